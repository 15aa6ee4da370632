#include "meshalyzer/repair/driver/internal/face_cover.h"

#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/lexicographic.h"
#include "meshalyzer/base/point_table.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/triangle_distance.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
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

/// Triangles between points.
struct IndexedParts {
  /// The corners of the parts, each once, in lexicographic order.
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;

  [[nodiscard]] Corners corners(const Triangle& t) const { return corners_of(points, t); }
};

IndexedParts index_corners(std::span<const Corners> parts) {
  IndexedParts indexed;
  std::vector<Vec3> found;
  PointTable table(3 * parts.size());
  for (const Corners& part : parts) {
    indexed.triangles.push_back(
        {table.insert(found, part[0]), table.insert(found, part[1]), table.insert(found, part[2])});
  }
  std::vector<Index> order(found.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return lexicographically_less(found[a], found[b]); });
  std::vector<Index> place(found.size());
  for (Index i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    indexed.points.push_back(found[order[i]]);
  }
  for (Triangle& t : indexed.triangles) {
    for (Index& corner : t) corner = place[corner];
  }
  return indexed;
}

/// An edge of a part with its lower end first, and the number of times that parts run along it,
/// less the times in the other direction.
struct CountedEdge {
  std::array<Index, 2> ends{};
  int count = 0;
};

CountedEdge count_edge(Index from, Index to, int count) {
  return from < to ? CountedEdge{{from, to}, count} : CountedEdge{{to, from}, -count};
}

/// Merges edges between the same ends, and removes those that cancel.
void add_up(std::vector<CountedEdge>& edges) {
  std::sort(edges.begin(), edges.end(),
            [](const CountedEdge& a, const CountedEdge& b) { return a.ends < b.ends; });
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
std::vector<CountedEdge> sum_of_boundaries(const IndexedParts& parts, const Vec3& normal) {
  std::vector<CountedEdge> edges;
  edges.reserve(3 * parts.triangles.size());
  for (const Triangle& t : parts.triangles) {
    const int sign = normal_of(parts.corners(t)).dot(normal) < 0.0 ? -1 : 1;
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(count_edge(t[i], t[(i + 1) % 3], sign));
  }
  add_up(edges);
  return edges;
}

/// Merges corners that are nearer to each other than the slack.
/// @return The largest distance by which a corner moved.
double merge_corners(IndexedParts& parts, double slack) {
  const std::vector<Vec3>& points = parts.points;
  std::vector<Index> stands_for(points.size());
  double moved = 0.0;
  for (Index i = 0; i < points.size(); ++i) {
    stands_for[i] = i;
    for (Index j = i; j-- > 0 && points[i].x() - points[j].x() <= slack;) {
      const double distance = (points[i] - points[j]).norm();
      if (stands_for[j] != j || distance > slack) continue;
      stands_for[i] = j;
      moved = std::max(moved, distance);
      break;
    }
  }
  for (Triangle& t : parts.triangles) {
    for (Index& corner : t) corner = stands_for[corner];
  }
  return moved;
}

/// Splits edges at the ends of others that are nearer to them than the slack, so that a long edge
/// cancels the short ones along it.
/// @return The largest distance by which an edge moved.
double split_at_corners(const std::vector<Vec3>& points, double slack,
                        std::vector<CountedEdge>& edges) {
  std::vector<Index> ends;
  for (const CountedEdge& edge : edges) ends.insert(ends.end(), edge.ends.begin(), edge.ends.end());
  sort_unique(ends);
  double moved = 0.0;
  std::vector<CountedEdge> split;
  std::vector<std::pair<double, Index>> on_edge;
  for (const CountedEdge& edge : edges) {
    const Vec3& origin = points[edge.ends[0]];
    const Vec3 along = points[edge.ends[1]] - origin;
    on_edge.clear();
    for (const Index end : ends) {
      const double at = (points[end] - origin).dot(along) / along.squaredNorm();
      const double distance = (points[end] - origin - at * along).norm();
      const bool is_own = end == edge.ends[0] || end == edge.ends[1];
      if (is_own || !(at > 0.0 && at < 1.0) || distance > slack) continue;
      on_edge.emplace_back(at, end);
      moved = std::max(moved, distance);
    }
    std::sort(on_edge.begin(), on_edge.end());
    Index from = edge.ends[0];
    for (const auto& [at, end] : on_edge) {
      split.push_back(count_edge(from, end, edge.count));
      from = end;
    }
    split.push_back(count_edge(from, edge.ends[1], edge.count));
  }
  edges = std::move(split);
  add_up(edges);
  return moved;
}

/// Returns the largest distance of a corner of a part from a face.
double distance_of_corners(const IndexedParts& parts, const Corners& face) {
  std::vector<std::uint8_t> is_used(parts.points.size(), 0);
  double largest = 0.0;
  for (const Triangle& t : parts.triangles) {
    for (const Index corner : t) {
      if (std::exchange(is_used[corner], 1) != 0) continue;
      largest = std::max(largest, closest_on_triangle(face, parts.points[corner]).distance);
    }
  }
  return largest;
}

/// Returns the distance of the farther end of a segment from the nearest edge of a face.
double distance_from_edge(const Segment& segment, const Corners& face) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = face[i];
    const Vec3& b = face[(i + 1) % 3];
    nearest = std::min(nearest, std::max(distance_from_segment(a, b, segment[0]),
                                         distance_from_segment(a, b, segment[1])));
  }
  return nearest;
}

/// Returns how many times a cycle of edges that are far from the centre of a face winds round it,
/// seen along the face's normal.
int winding_number(const std::vector<Vec3>& points, std::span<const CountedEdge> cycle,
                   const Corners& face, const Vec3& centre) {
  const Vec3 right = (face[0] - centre).stableNormalized();
  const Vec3 up = normal_of(face).stableNormalized().cross(right);
  int winding = 0;
  // Each edge that crosses the ray from the centre to the right counts.
  for (const auto& [ends, count] : cycle) {
    const Vec3 from = points[ends[0]] - centre;
    const Vec3 to = points[ends[1]] - centre;
    const bool goes_up = from.dot(up) < 0.0;
    if (goes_up == (to.dot(up) < 0.0)) continue;
    const double area = from.dot(right) * to.dot(up) - to.dot(right) * from.dot(up);
    if (goes_up && area > 0.0) winding += count;
    if (!goes_up && area < 0.0) winding -= count;
  }
  return winding;
}

}  // namespace

std::optional<double> distance_from_parts(const Corners& face, std::span<const Corners> parts,
                                          double slack) {
  /// The factor by which the incircle must exceed the inaccuracy of the parts.
  constexpr double kMargin = 4.0;
  /// With more edges than this they are not compared with each other.
  constexpr std::size_t kMostSplitEdges = 1000;
  const Vec3 normal = normal_of(face);
  IndexedParts merged = index_corners(parts);
  const std::vector<Vec3>& points = merged.points;
  double moved = slack > 0.0 ? merge_corners(merged, slack) : 0.0;
  std::vector<CountedEdge> border = sum_of_boundaries(merged, normal);
  if (slack > 0.0 && border.size() <= kMostSplitEdges) {
    moved += split_at_corners(points, slack, border);
  }
  double inaccuracy = distance_of_corners(merged, face);
  for (const auto& [ends, count] : border) {
    inaccuracy = std::max(inaccuracy, distance_from_edge({points[ends[0]], points[ends[1]]}, face));
  }
  inaccuracy += moved;
  const Incircle circle = incircle_of(face);
  const bool is_covered = circle.radius > kMargin * inaccuracy &&
                          winding_number(points, border, face, circle.centre) != 0;
  if (!is_covered) return std::nullopt;
  // Shrinking the face towards the incentre makes it that deep; no point moves farther than a
  // corner.
  double farthest = 0.0;
  for (const Vec3& corner : face) farthest = std::max(farthest, (corner - circle.centre).norm());
  return inaccuracy * (1.0 + farthest / circle.radius);
}

}  // namespace meshalyzer
