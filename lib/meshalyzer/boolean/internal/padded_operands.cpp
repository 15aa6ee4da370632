#include "meshalyzer/boolean/internal/padded_operands.h"

#include "meshalyzer/exact/normal.h"
#include "meshalyzer/spatial/direction_off.h"
#include "meshalyzer/spatial/oblique_direction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace meshalyzer {
namespace {

/// The thickness behind the faces, as a share of that in front of them. It is another one, so that
/// the pads of the two walls of a gap have no planes in common.
constexpr double kShareBehind = 0.3;
/// At a vertex that no direction leaves faster than this, a pad is hardly thick.
constexpr double kLeastClearance = 0.01;
/// The distance of the corners of the tetrahedron there, in multiples of the thickness.
constexpr double kSizeOfTetrahedra = 4.0;

/// The corners of a regular tetrahedron round the origin, at a distance of 1, askew to the axes.
std::array<Vec3, 4> regular_tetrahedron() {
  const Vec3 x = kObliqueDirection;
  const Vec3 y = x.unitOrthogonal();
  const Vec3 z = x.cross(y);
  const double third = 1.0 / std::sqrt(3.0);
  return {third * (x + y + z), third * (x - y - z), third * (y - x - z), third * (z - x - y)};
}

constexpr std::array<Triangle, 4> kFacesOfTetrahedron{{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};

using Directions = std::map<Index, DirectionOff>;

/// Finds the faces that have at least one of some vertices.
std::vector<Index> find_faces_at(const Soup& mesh, const std::set<Index>& vertices) {
  std::vector<Index> faces;
  for (Index face = 0; face < mesh.n_faces(); ++face) {
    const Triangle& t = mesh.triangles[face];
    const auto is_one = [&](Index v) { return vertices.contains(v); };
    if (std::any_of(t.begin(), t.end(), is_one)) faces.push_back(face);
  }
  return faces;
}

/// Finds the direction that leaves all faces at each vertex.
///
/// @param faces  All faces that have one of the vertices.
Directions find_directions(const Soup& mesh, const std::set<Index>& vertices,
                           std::span<const Index> faces) {
  std::map<Index, std::vector<Vec3>> normals;
  for (const Index face : faces) {
    const auto [a, b, c] = corners_of(mesh, face);
    const Vec3 normal = accurate_normal(a, b, c);
    if (!(normal.stableNorm() > 0.0)) continue;
    for (const Index v : mesh.triangles[face]) {
      if (vertices.contains(v)) normals[v].push_back(normal.stableNormalized());
    }
  }
  Directions directions;
  for (const Index v : vertices) {
    directions[v] = normals.contains(v) ? direction_off(normals[v]) : DirectionOff();
  }
  return directions;
}

}  // namespace

PaddedOperands::PaddedOperands(const Operands& operands)
    : of_face_(operands.of_face), n_operands_(operands.count + 2) {
  soup_.positions = operands.soup.positions;
  soup_.triangles = operands.soup.triangles;
}

void PaddedOperands::add_pad(const Soup& mesh, std::span<const Index> faces, double thickness) {
  std::set<Index> thick;
  for (const Index face : faces) {
    thick.insert(mesh.triangles[face].begin(), mesh.triangles[face].end());
  }
  const std::vector<Index> padded = find_faces_at(mesh, thick);
  // By vertex of the mesh: its copies in front of the faces and behind them, one at the rim.
  std::map<Index, std::array<Index, 2>> copies;
  for (const auto& [vertex, off] : find_directions(mesh, thick, padded)) {
    const Vec3& p = mesh.positions[vertex];
    const Vec3 step = thickness / std::max(off.clearance, 1.0 / kMostPadding) * off.direction;
    copies[vertex] = {add_vertex(p + step), add_vertex(p - kShareBehind * step)};
    if (off.clearance < kLeastClearance) add_tetrahedron(p, kSizeOfTetrahedra * thickness);
  }
  for (const Index face : padded) {
    Triangle front = mesh.triangles[face];
    Triangle behind = front;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [found, is_at_rim] = copies.try_emplace(front[k]);
      if (is_at_rim) found->second.fill(add_vertex(mesh.positions[front[k]]));
      front[k] = found->second[0];
      behind[k] = found->second[1];
    }
    std::swap(behind[1], behind[2]);
    add_face(front, n_operands_ - 2);
    add_face(behind, n_operands_ - 2);
  }
}

Index PaddedOperands::add_vertex(const Vec3& position) {
  soup_.positions.push_back(position);
  return static_cast<Index>(soup_.positions.size() - 1);
}

void PaddedOperands::add_face(const Triangle& corners, std::size_t operand) {
  soup_.triangles.push_back(corners);
  of_face_.push_back(static_cast<Index>(operand));
}

void PaddedOperands::add_tetrahedron(const Vec3& middle, double size) {
  static const std::array<Vec3, 4> kCorners = regular_tetrahedron();
  const auto first = static_cast<Index>(soup_.positions.size());
  for (const Vec3& corner : kCorners) add_vertex(middle + size * corner);
  for (Triangle t : kFacesOfTetrahedron) {
    for (Index& v : t) v += first;
    add_face(t, n_operands_ - 1);
  }
}

InsideRule PaddedOperands::rule() {
  return [difference = difference_rule()](std::span<const int> windings) {
    // A pad is turned inside out where its faces are folded, and takes away all the same.
    const auto others = windings.first(windings.size() - 2);
    return difference(others) && windings[others.size()] == 0 && windings.back() == 0;
  };
}

}  // namespace meshalyzer
