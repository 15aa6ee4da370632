#include "meshalyzer/boolean/internal/blocking_faces.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/self_intersection_of.h"
#include "meshalyzer/spatial/triangle_distance.h"

#include <algorithm>
#include <cstdint>

namespace meshalyzer {
namespace {

using Marks = std::vector<std::uint8_t>;

Marks mark_moved_vertices(const PartedMesh& moved) {
  Marks is_moved(moved.start.size(), 0);
  for (std::size_t v = 0; v < is_moved.size(); ++v) {
    is_moved[v] = moved.mesh.positions[v] != moved.start[v] ? 1 : 0;
  }
  return is_moved;
}

/// Marks the moved vertices of faces that intersect others of their mesh.
Marks mark_clashing_vertices(const PartedMesh& moved) {
  const CutMesh cut = build(moved.mesh);
  Marks is_clashing(moved.start.size(), 0);
  const Marks is_moved = mark_moved_vertices(moved);
  std::vector<Index> faces;
  for (Index face = 0; face < moved.mesh.n_faces(); ++face) {
    const Triangle& t = moved.mesh.triangles[face];
    if (std::any_of(t.begin(), t.end(), [&](Index v) { return is_moved[v] != 0; })) {
      faces.push_back(face);
    }
  }
  for (const auto& pair : find_self_intersections_of(cut, moved.mesh, faces).listed) {
    for (const Index face : {pair.face_a, pair.face_b}) {
      for (const Index v : moved.mesh.triangles[face]) is_clashing[v] |= is_moved[v];
    }
  }
  return is_clashing;
}

}  // namespace

std::vector<Index> find_blocking_faces(const PartedMesh& moved) {
  std::vector<Index> blocking;
  for (const IntersectingPair& pair : moved.left) blocking.push_back(pair.face_b);
  const Marks is_clashing = mark_clashing_vertices(moved);
  for (const IntersectingPair& pair : moved.touching) {
    const Triangle& t = moved.mesh.triangles[pair.face_a];
    const bool is_in_the_way = std::any_of(t.begin(), t.end(), [&](Index v) {
      return is_clashing[v] != 0 &&
             closest_on_triangle(corners_of(moved.others, pair.face_b), moved.start[v]).distance <=
                 moved.near;
    });
    if (is_in_the_way) blocking.push_back(pair.face_b);
  }
  sort_unique(blocking);
  return blocking;
}

}  // namespace meshalyzer
