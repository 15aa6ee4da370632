#include "direct_evaluation.h"

#include "meshalyzer/geometry/vertex_normals.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/triangle_distance.h"
#include "support/constants.h"
#include "support/rational_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

namespace meshalyzer::test {
namespace {

Corners corners_of(const Soup& soup, const Triangle& t) {
  return {soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]};
}

std::array<std::pair<Index, Index>, 3> edges_of(const Triangle& t) {
  return {std::minmax({t[0], t[1]}), std::minmax({t[1], t[2]}), std::minmax({t[2], t[0]})};
}

/// The lowest vertex that each one hangs together with.
std::vector<Index> lowest_vertices(const Soup& soup) {
  std::vector<Index> lowest(soup.n_vertices());
  std::iota(lowest.begin(), lowest.end(), Index{0});
  for (bool changed = true; changed;) {
    changed = false;
    for (const Triangle& t : soup.triangles) {
      if (is_in_complex(t)) {
        const Index low = std::min({lowest[t[0]], lowest[t[1]], lowest[t[2]]});
        for (const Index v : t) {
          changed = changed || lowest[v] != low;
          lowest[v] = low;
        }
      }
    }
  }
  return lowest;
}

bool is_on(const Vec3& p, const Corners& t) {
  if (rational_orient3d(t[0], t[1], t[2], p) != 0) {
    return false;
  }
  constexpr std::array kAxes{Axis::X, Axis::Y, Axis::Z};
  return std::all_of(kAxes.begin(), kAxes.end(), [&](Axis dropped) {
    const Sign turn = rational_orient2d(dropped, t[0], t[1], t[2]);
    return turn == 0 || (rational_orient2d(dropped, t[0], t[1], p) * turn >= 0 &&
                         rational_orient2d(dropped, t[1], t[2], p) * turn >= 0 &&
                         rational_orient2d(dropped, t[2], t[0], p) * turn >= 0);
  });
}

/// Tells whether the segment p q meets a triangle that p is not on; nothing where it meets its
/// border.
std::optional<bool> meets(const Vec3& p, const Vec3& q, const Corners& t) {
  const Sign side = rational_orient3d(t[0], t[1], t[2], q);
  if (side == 0) {
    return std::nullopt;
  }
  if (rational_orient3d(t[0], t[1], t[2], p) != -side) {
    return false;
  }
  const auto [low, high] =
      std::minmax({rational_orient3d(p, q, t[0], t[1]), rational_orient3d(p, q, t[1], t[2]),
                   rational_orient3d(p, q, t[2], t[0])});
  if (low * high == 0) {
    return low == high || low + high != 0 ? std::nullopt : std::optional(false);
  }
  return low == high;
}

/// Tells whether the segment p q meets an odd number of faces; nothing where it meets a border.
std::optional<bool> meets_odd(const Vec3& p, const Vec3& q, const Soup& soup,
                              const std::vector<Triangle>& faces) {
  bool is_odd = false;
  for (const Triangle& t : faces) {
    const std::optional<bool> is_met = meets(p, q, corners_of(soup, t));
    if (!is_met) {
      return std::nullopt;
    }
    is_odd = is_odd != *is_met;
  }
  return is_odd;
}

/// The closest point to a vertex.
struct Found {
  double distance = std::numeric_limits<double>::quiet_NaN();
  Index object = kNoIndex;
  std::int64_t face = 0;
  Vec3 point = Vec3::Zero();
};

bool is_used(const Soup& soup, Index vertex) {
  return std::any_of(soup.triangles.begin(), soup.triangles.end(), [&](const Triangle& t) {
    return is_in_complex(t) && std::find(t.begin(), t.end(), vertex) != t.end();
  });
}

class SeparationJudge {
 public:
  SeparationJudge(const std::vector<Soup>& objects, Index number, const SeparationOptions& options)
      : objects_(objects),
        number_(number),
        options_(options),
        normals_(vertex_normals(build(objects[number]))),
        path_lengths_(path_lengths(objects[number])) {
    std::transform(objects.begin(), objects.end(), std::back_inserter(solids_), enclosing_faces);
  }

  [[nodiscard]] Found closest_to(Index vertex) const {
    Found best;
    for (Index other = 0; other < objects_.size(); ++other) {
      const Soup& soup = objects_[other];
      for (Index f = 0; f < soup.n_faces(); ++f) {
        if (counts(vertex, other, soup.triangles[f])) {
          const auto found = ask(vertex, corners_of(soup, soup.triangles[f]));
          if (found && !(found->distance >= best.distance)) {
            best = {found->distance, other, soup.face_ids.of(f), found->point};
          }
        }
      }
    }
    return best;
  }

  [[nodiscard]] bool is_inside(Index vertex) const {
    for (Index other = 0; other < objects_.size(); ++other) {
      if (other != number_ && direct_side(objects_[other], solids_[other],
                                          objects_[number_].positions[vertex]) == Side::Inside) {
        return true;
      }
    }
    return false;
  }

 private:
  [[nodiscard]] bool counts(Index vertex, Index other, const Triangle& t) const {
    if (!is_in_complex(t) || other != number_) {
      return is_in_complex(t);
    }
    return options_.include_self && std::all_of(t.begin(), t.end(), [&](Index corner) {
             return path_lengths_[vertex][corner] > *options_.include_self;
           });
  }

  [[nodiscard]] std::optional<TrianglePoint> ask(Index vertex, const Corners& t) const {
    const Vec3& point = objects_[number_].positions[vertex];
    std::optional<TrianglePoint> found = closest_on_triangle(t, point);
    if (options_.search_cone_degrees) {
      const double cosine = std::cos(*options_.search_cone_degrees * std::numbers::pi / 180.0);
      found = closest_on_triangle(t, point, Cone{normals_[vertex], cosine});
    }
    return found && found->distance <= options_.search_radius.value_or(kInfinity) ? found
                                                                                  : std::nullopt;
  }

  const std::vector<Soup>& objects_;
  Index number_;
  const SeparationOptions& options_;
  std::vector<Vec3> normals_;
  std::vector<std::vector<double>> path_lengths_;
  std::vector<std::vector<Triangle>> solids_;
};

}  // namespace

std::vector<std::vector<double>> path_lengths(const Soup& soup) {
  const std::size_t n = soup.n_vertices();
  std::vector<std::vector<double>> length(n, std::vector<double>(n, kInfinity));
  for (const Triangle& t : soup.triangles) {
    if (is_in_complex(t)) {
      for (const auto& [a, b] : edges_of(t)) {
        length[a][b] = length[b][a] = (soup.positions[a] - soup.positions[b]).norm();
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    length[i][i] = 0.0;
  }
  for (std::size_t by = 0; by < n; ++by) {
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b) {
        length[a][b] = std::min(length[a][b], length[a][by] + length[by][b]);
      }
    }
  }
  return length;
}

std::vector<Triangle> enclosing_faces(const Soup& soup) {
  std::map<std::pair<Index, Index>, int> n_faces;
  for (const Triangle& t : soup.triangles) {
    if (is_in_complex(t)) {
      for (const auto& edge : edges_of(t)) {
        ++n_faces[edge];
      }
    }
  }
  const std::vector<Index> component = lowest_vertices(soup);
  std::vector<std::uint8_t> encloses(soup.n_vertices(), 1);
  for (const auto& [edge, n] : n_faces) {
    if (n != 2) {
      encloses[component[edge.first]] = 0;
    }
  }
  std::vector<Triangle> faces;
  std::copy_if(
      soup.triangles.begin(), soup.triangles.end(), std::back_inserter(faces),
      [&](const Triangle& t) { return is_in_complex(t) && encloses[component[t[0]]] != 0; });
  return faces;
}

Side direct_side(const Soup& soup, const std::vector<Triangle>& faces, const Vec3& point) {
  Box3 box;
  for (const Triangle& t : faces) {
    for (const Vec3& corner : corners_of(soup, t)) {
      box.extend(corner);
    }
  }
  if (!box.contains(point)) {
    return Side::Outside;
  }
  if (std::any_of(faces.begin(), faces.end(),
                  [&](const Triangle& t) { return is_on(point, corners_of(soup, t)); })) {
    return Side::OnSurface;
  }
  const double far = 64 * box.diagonal().maxCoeff();
  for (const Vec3& direction : {Vec3(0.71, 0.43, 0.19), Vec3(-0.23, 0.83, 0.37),
                                Vec3(0.11, -0.31, 0.97), Vec3(-0.61, -0.53, -0.47)}) {
    if (const auto is_odd = meets_odd(point, point + far * direction, soup, faces)) {
      return *is_odd ? Side::Inside : Side::Outside;
    }
  }
  throw std::logic_error("every segment meets an edge");
}

ObjectSeparation direct_separation(const std::vector<Soup>& objects, Index object,
                                   const SeparationOptions& options) {
  const SeparationJudge judge(objects, object, options);
  const Soup& soup = objects[object];
  ObjectSeparation result;
  for (Index v = 0; v < soup.n_vertices(); ++v) {
    if (is_used(soup, v)) {
      const Found found = judge.closest_to(v);
      result.vertices.push_back(soup.vertex_ids.of(v));
      result.distances.push_back(judge.is_inside(v) ? -found.distance : found.distance);
      result.objects.push_back(found.object);
      result.faces.push_back(found.face);
      result.points.push_back(found.point);
    }
  }
  return result;
}

}  // namespace meshalyzer::test
