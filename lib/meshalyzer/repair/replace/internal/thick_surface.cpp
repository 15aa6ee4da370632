#include "meshalyzer/repair/replace/internal/thick_surface.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/runs.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/exact/normal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>

namespace meshalyzer {
namespace {

/// A face at an edge.
struct FaceRoundEdge {
  /// The ends of the edge, the lower first.
  std::array<Index, 2> ends{};
  /// The index of the face in the list, and of the corner from which it runs along the edge.
  std::size_t face = 0;
  std::size_t corner = 0;
  /// The direction of the face as seen along the edge.
  double angle = 0.0;
};

/// An edge at which a rim ends, in the direction of the rim.
struct RimEnd {
  Index from = kNoIndex;
  Index to = kNoIndex;
  std::size_t face = 0;
};

/// The two sides of a face: in front of it, where its normal points, and behind it.
constexpr std::size_t kFront = 0;
constexpr std::size_t kBehind = 1;

class Thickening {
 public:
  Thickening(const Soup& soup, std::span<const Index> faces, double thickness)
      : soup_(soup), faces_(faces), sets_(6 * faces.size()) {
    find_edges();
    join_all_sides();
    place_vertices(thickness / 2.0);
  }

  /// Tells whether both walls of a face, by its index in the list, lie on their sides of it, and
  /// face away from it.
  [[nodiscard]] bool has_walls_in_place(std::size_t f) const {
    const Corners middle = corners_of(soup_, faces_[f]);
    const Vec3 normal = unit_normal(middle);
    const auto is_in_place = [&](std::size_t side) {
      const Vec3 out = side == kFront ? normal : Vec3(-normal);
      Corners wall;
      for (std::size_t k = 0; k < 3; ++k) {
        wall[k] = surface_.positions[corner(f, side, k)];
        if ((wall[k] - middle[k]).dot(out) < 0.0) return false;
      }
      return normal_of(wall).dot(normal) > 0.0;
    };
    return is_in_place(kFront) && is_in_place(kBehind);
  }

  NewSurface run() {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      add({corner(f, kFront, 0), corner(f, kFront, 1), corner(f, kFront, 2)}, f);
      add({corner(f, kBehind, 0), corner(f, kBehind, 2), corner(f, kBehind, 1)}, f);
    }
    for (const auto& [f, from] : borders_) add_rim(f, from);
    close_rims();
    return std::move(surface_);
  }

 private:
  [[nodiscard]] const Triangle& triangle(std::size_t f) const { return soup_.triangles[faces_[f]]; }

  void find_edges() {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = triangle(f)[k];
        const Index b = triangle(f)[(k + 1) % 3];
        edges_.push_back({{std::min(a, b), std::max(a, b)}, f, k, 0.0});
      }
    }
    std::sort(edges_.begin(), edges_.end(), [](const FaceRoundEdge& a, const FaceRoundEdge& b) {
      return std::pair(a.ends, a.face) < std::pair(b.ends, b.face);
    });
  }

  /// Sorts the faces at an edge by angle.
  void sort_round(std::span<FaceRoundEdge> edge) const {
    const Vec3& from = soup_.positions[edge.front().ends[0]];
    const Vec3 axis = (soup_.positions[edge.front().ends[1]] - from).stableNormalized();
    const Vec3 x = axis.unitOrthogonal();
    const Vec3 y = axis.cross(x);
    for (FaceRoundEdge& at : edge) {
      const Vec3 to = soup_.positions[triangle(at.face)[(at.corner + 2) % 3]] - from;
      at.angle = std::atan2(to.dot(y), to.dot(x));
    }
    std::sort(edge.begin(), edge.end(), [](const FaceRoundEdge& a, const FaceRoundEdge& b) {
      return std::pair(a.angle, a.face) < std::pair(b.angle, b.face);
    });
  }

  [[nodiscard]] bool goes_along(const FaceRoundEdge& at) const {
    return triangle(at.face)[at.corner] == at.ends[0];
  }

  static std::size_t name(std::size_t face, std::size_t side, std::size_t corner) {
    return 6 * face + 3 * side + corner % 3;
  }

  void join_all_sides() {
    for_each_run(std::span(edges_), &FaceRoundEdge::ends, [&](std::span<FaceRoundEdge> edge) {
      if (edge.size() == 1) {
        borders_.emplace_back(edge.front().face, edge.front().corner);
        return;
      }
      if (edge.size() > 2) sort_round(edge);
      for (std::size_t i = 0; i < edge.size(); ++i) join(edge[i], edge[(i + 1) % edge.size()]);
    });
  }

  /// Joins the side of a face that faces forward round the edge to the side of the next face that
  /// faces back.
  void join(const FaceRoundEdge& a, const FaceRoundEdge& b) {
    const std::size_t ahead = goes_along(a) ? kFront : kBehind;
    const std::size_t back = goes_along(b) ? kBehind : kFront;
    const std::size_t turn = goes_along(a) == goes_along(b) ? 0 : 1;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      sets_.unite(static_cast<Index>(name(a.face, ahead, a.corner + k)),
                  static_cast<Index>(name(b.face, back, b.corner + (k ^ turn))));
    }
  }

  void place_vertices(double distance) {
    constexpr Index kNone = kNoIndex;
    std::vector<Vec3> normals(6 * faces_.size(), Vec3::Zero());
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const Vec3 normal = unit_normal(corners_of(soup_, faces_[f]));
      for (std::size_t k = 0; k < 6; ++k) {
        const std::size_t set = sets_.find(static_cast<Index>(6 * f + k));
        normals[set] += k < 3 ? normal : Vec3(-normal);
      }
    }
    std::vector<Index> vertex_of(6 * faces_.size(), kNone);
    vertices_.resize(6 * faces_.size());
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const std::size_t set = sets_.find(static_cast<Index>(i));
      if (vertex_of[set] == kNone) {
        vertex_of[set] = static_cast<Index>(surface_.positions.size());
        const Vec3& at = soup_.positions[triangle(i / 6)[i % 3]];
        surface_.positions.push_back(at + distance * normals[set].stableNormalized());
      }
      vertices_[i] = vertex_of[set];
    }
  }

  [[nodiscard]] Index corner(std::size_t face, std::size_t side, std::size_t k) const {
    return vertices_[name(face, side, k)];
  }

  void add(const Triangle& t, std::size_t face) {
    surface_.triangles.push_back(t);
    surface_.origins.push_back(faces_[face]);
  }

  void add_rim(std::size_t f, std::size_t from) {
    const Index a = corner(f, kFront, from);
    const Index b = corner(f, kFront, from + 1);
    const Index c = corner(f, kBehind, from);
    const Index d = corner(f, kBehind, from + 1);
    if (a != c) add({b, a, c}, f);
    if (b != d) add({b, c, d}, f);
    ends_.push_back({a, c, f});
    ends_.push_back({d, b, f});
  }

  /// Closes the gaps that rims leave where more than two meet, as at the end of an edge with three
  /// faces.
  void close_rims() {
    std::map<std::pair<Index, Index>, std::size_t> open;
    for (const RimEnd& end : ends_) {
      if (end.from == end.to) continue;
      const auto back = open.find({end.to, end.from});
      if (back != open.end()) {
        open.erase(back);
      } else {
        open[{end.from, end.to}] = end.face;
      }
    }
    while (!open.empty()) {
      const auto [start, face] = *open.begin();
      open.erase(open.begin());
      Index at = start.second;
      for (auto next = open.lower_bound({at, 0}); next != open.end() && next->first.first == at;
           next = open.lower_bound({at, 0})) {
        const Index to = next->first.second;
        open.erase(next);
        if (to != start.first) add({start.first, to, at}, face);
        at = to;
      }
    }
  }

  const Soup& soup_;
  std::span<const Index> faces_;
  std::vector<FaceRoundEdge> edges_;
  /// Faces at borders, and the corner from which they run along.
  std::vector<std::pair<std::size_t, std::size_t>> borders_;
  std::vector<RimEnd> ends_;
  /// The sets of corners of sides that are one vertex, see name().
  DisjointSets sets_;
  std::vector<Index> vertices_;
  NewSurface surface_;
};

void append(const NewSurface& added, NewSurface& surface) {
  const auto n_before = static_cast<Index>(surface.positions.size());
  surface.positions.insert(surface.positions.end(), added.positions.begin(), added.positions.end());
  for (const Triangle& t : added.triangles) {
    surface.triangles.push_back({t[0] + n_before, t[1] + n_before, t[2] + n_before});
  }
  surface.origins.insert(surface.origins.end(), added.origins.begin(), added.origins.end());
}

/// Makes one thin solid of as many faces as can be joined, and adds it to a surface.
///
/// @return  The other faces, which are separable.
std::vector<Index> thicken_joined(const Soup& soup, std::vector<Index> faces, double thickness,
                                  std::span<const Index> separable, NewSurface& surface) {
  std::vector<Index> left;
  for (;;) {
    Thickening thickening(soup, faces, thickness);
    std::vector<Index> in_place;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const bool may_leave = std::binary_search(separable.begin(), separable.end(), faces[f]);
      (may_leave && !thickening.has_walls_in_place(f) ? left : in_place).push_back(faces[f]);
    }
    if (in_place.size() == faces.size()) {
      append(thickening.run(), surface);
      return left;
    }
    faces = std::move(in_place);
  }
}

}  // namespace

NewSurface thicken(const Soup& soup, std::span<const Index> faces, double thickness,
                   std::span<const Index> separable) {
  NewSurface surface;
  std::vector<Index> left(faces.begin(), faces.end());
  for (std::size_t n_before = 0; left.size() != n_before;) {
    n_before = left.size();
    left = thicken_joined(soup, left, thickness, separable, surface);
  }
  // Those that cannot be joined to any other become prisms.
  for (const Index& face : left) append(Thickening(soup, {&face, 1}, thickness).run(), surface);
  return surface;
}

}  // namespace meshalyzer
