#include "meshalyzer/repair/driver/internal/face_cover.h"

#include "meshalyzer/base/lexicographic.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/repair/driver/internal/face_distance.h"
#include "meshalyzer/spatial/closest_point.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace meshalyzer {

namespace {

using Segment = std::array<Vec3, 2>;

/// The inscribed circle of a triangle.
struct Incircle {
  Vec3 centre;
  double radius = 0.0;
};

Incircle incircle_of(const Corners& t) {
  const double a = (t[2] - t[1]).norm();
  const double b = (t[0] - t[2]).norm();
  const double c = (t[1] - t[0]).norm();
  const double perimeter = a + b + c;
  return {(a * t[0] + b * t[1] + c * t[2]) / perimeter, normal_of(t).norm() / perimeter};
}

/// An edge of a part with its lower end first, and the number of times that parts run along it,
/// less the times in the other direction.
struct CountedEdge {
  Segment ends;
  int count = 0;
};

CountedEdge count_edge(const Vec3& from, const Vec3& to, int count) {
  return lexicographically_less(from, to) ? CountedEdge{{from, to}, count}
                                          : CountedEdge{{to, from}, -count};
}

/// Merges edges between the same ends, and removes those that cancel.
void add_up(std::vector<CountedEdge>& edges) {
  std::sort(edges.begin(), edges.end(), [](const CountedEdge& a, const CountedEdge& b) {
    return std::lexicographical_compare(a.ends.begin(), a.ends.end(), b.ends.begin(), b.ends.end(),
                                        lexicographically_less);
  });
  std::size_t n = 0;
  for (const CountedEdge& edge : edges) {
    if (n > 0 && edges[n - 1].ends == edge.ends) {
      edges[n - 1].count += edge.count;
    } else {
      edges[n++] = edge;
    }
  }
  edges.resize(n);
  std::erase_if(edges, [](const CountedEdge& edge) {
    return edge.count == 0 || edge.ends[0] == edge.ends[1];
  });
}

/// Returns the sum of the boundaries of the parts, each turned to the side of the normal.
std::vector<CountedEdge> sum_of_boundaries(std::span<const Corners> parts, const Vec3& normal) {
  std::vector<CountedEdge> edges;
  edges.reserve(3 * parts.size());
  for (const Corners& part : parts) {
    const int sign = normal_of(part).dot(normal) < 0.0 ? -1 : 1;
    for (std::size_t i = 0; i < 3; ++i) {
      edges.push_back(count_edge(part[i], part[(i + 1) % 3], sign));
    }
  }
  add_up(edges);
  return edges;
}

/// Sorts points and removes repeated ones.
void sort_unique_points(std::vector<Vec3>& points) {
  std::sort(points.begin(), points.end(), lexicographically_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

/// Merges corners that are nearer to each other than the slack.
/// @return The largest distance by which a corner moved.
double merge_corners(std::vector<Corners>& parts, double slack) {
  std::vector<Vec3> points;
  for (const Corners& part : parts) points.insert(points.end(), part.begin(), part.end());
  sort_unique_points(points);
  std::vector<std::size_t> stands_for(points.size());
  double moved = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    stands_for[i] = i;
    for (std::size_t j = i; j-- > 0 && points[i].x() - points[j].x() <= slack;) {
      const double distance = (points[i] - points[j]).norm();
      if (stands_for[j] != j || distance > slack) continue;
      stands_for[i] = j;
      moved = std::max(moved, distance);
      break;
    }
  }
  for (Corners& part : parts) {
    for (Vec3& corner : part) {
      const auto at =
          std::lower_bound(points.begin(), points.end(), corner, lexicographically_less);
      corner = points[stands_for[static_cast<std::size_t>(at - points.begin())]];
    }
  }
  return moved;
}

/// Splits edges at the ends of others that are nearer to them than the slack, so that a long edge
/// cancels the short ones along it.
/// @return The largest distance by which an edge moved.
double split_at_corners(std::vector<CountedEdge>& edges, double slack) {
  std::vector<Vec3> points;
  for (const CountedEdge& edge : edges) {
    points.insert(points.end(), edge.ends.begin(), edge.ends.end());
  }
  sort_unique_points(points);
  double moved = 0.0;
  std::vector<CountedEdge> split;
  std::vector<std::pair<double, std::size_t>> on_edge;
  for (const CountedEdge& edge : edges) {
    const Vec3 along = edge.ends[1] - edge.ends[0];
    on_edge.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double at = (points[i] - edge.ends[0]).dot(along) / along.squaredNorm();
      const double distance = (points[i] - edge.ends[0] - at * along).norm();
      const bool is_end = points[i] == edge.ends[0] || points[i] == edge.ends[1];
      if (is_end || !(at > 0.0 && at < 1.0) || distance > slack) continue;
      on_edge.emplace_back(at, i);
      moved = std::max(moved, distance);
    }
    std::sort(on_edge.begin(), on_edge.end());
    Vec3 from = edge.ends[0];
    for (const auto& [at, i] : on_edge) {
      split.push_back(count_edge(from, points[i], edge.count));
      from = points[i];
    }
    split.push_back(count_edge(from, edge.ends[1], edge.count));
  }
  edges = std::move(split);
  add_up(edges);
  return moved;
}

/// Returns the distance of the farther end of a segment from the nearest edge of a face.
double distance_from_edge(const Segment& segment, const Corners& face) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Corners edge{face[i], face[(i + 1) % 3], face[(i + 1) % 3]};
    nearest = std::min(nearest, std::max(closest_on_triangle(edge, segment[0]).distance,
                                         closest_on_triangle(edge, segment[1]).distance));
  }
  return nearest;
}

/// Tells whether a point lies in a triangle, seen along a direction.
bool contains(const Corners& t, const Vec3& point, const Vec3& direction) {
  const double side = normal_of(t).dot(direction) < 0.0 ? -1.0 : 1.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 normal = normal_of(t[i], t[(i + 1) % 3], point);
    if (side * normal.dot(direction) < 0.0) return false;
  }
  return true;
}

}  // namespace

std::optional<double> distance_from_parts(const Corners& face, std::span<const Corners> parts,
                                          double slack) {
  /// The factor by which the incircle must exceed the inaccuracy of the parts.
  constexpr double kMargin = 4.0;
  /// With more edges than this they are not compared with each other.
  constexpr std::size_t kMostSplitEdges = 1000;
  const Vec3 normal = normal_of(face);
  std::vector<Corners> merged(parts.begin(), parts.end());
  double moved = slack > 0.0 ? merge_corners(merged, slack) : 0.0;
  std::vector<CountedEdge> border = sum_of_boundaries(merged, normal);
  if (slack > 0.0 && border.size() <= kMostSplitEdges) moved += split_at_corners(border, slack);
  double inaccuracy = 0.0;
  for (const Corners& part : merged) {
    inaccuracy = std::max(inaccuracy, largest_distance(part, face));
  }
  for (const CountedEdge& edge : border) {
    inaccuracy = std::max(inaccuracy, distance_from_edge(edge.ends, face));
  }
  inaccuracy += moved;
  const Incircle circle = incircle_of(face);
  const bool is_covered = circle.radius > kMargin * inaccuracy &&
                          std::any_of(merged.begin(), merged.end(), [&](const Corners& part) {
                            return contains(part, circle.centre, normal);
                          });
  if (!is_covered) return std::nullopt;
  // Shrinking the face towards the incentre makes it that deep; no point moves farther than a
  // corner.
  double farthest = 0.0;
  for (const Vec3& corner : face) farthest = std::max(farthest, (corner - circle.centre).norm());
  return inaccuracy * (1.0 + farthest / circle.radius);
}

}  // namespace meshalyzer
