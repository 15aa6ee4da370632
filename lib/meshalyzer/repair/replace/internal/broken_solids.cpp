#include "meshalyzer/repair/replace/internal/broken_solids.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/repair/orient/bounds_solid.h"

#include <algorithm>
#include <cstdint>

namespace meshalyzer {
namespace {

/// Collects the faces at which a mesh is broken.
class BrokenFaces {
 public:
  explicit BrokenFaces(const PreparedMesh& mesh)
      : mesh_(mesh), cut_(mesh.cut()), is_broken_(mesh.soup().n_faces(), 0) {}

  std::vector<Index> find() {
    // If the complex is not manifold or not consistently oriented, the cut mesh has borders too.
    for (const HalfedgeHandle h : cut_.mesh.halfedges()) {
      const HalfedgeHandle opposite = cut_.mesh.opposite_halfedge_handle(h);
      if (!cut_.mesh.is_boundary(h) && cut_.mesh.is_boundary(opposite)) {
        is_broken_[cut_.side.face(cut_.mesh.face_handle(h))] = 1;
      }
    }
    for (const IntersectingPair& pair : mesh_.intersecting_pairs()) {
      is_broken_[pair.face_a] = 1;
      is_broken_[pair.face_b] = 1;
    }
    mark_pinched_and_flat();
    std::vector<Index> faces;
    for (Index face = 0; face < is_broken_.size(); ++face) {
      if (is_broken_[face] != 0) faces.push_back(face);
    }
    return faces;
  }

 private:
  void mark_pinched_and_flat() {
    const Soup& soup = mesh_.soup();
    std::vector<std::uint8_t> is_pinched(soup.n_vertices(), 0);
    for (const Index v : cut_.side.non_manifold_vertices) is_pinched[v] = 1;
    for (const Index face : cut_.side.faces) {
      const Triangle& t = soup.triangles[face];
      if (std::any_of(t.begin(), t.end(), [&](Index v) { return is_pinched[v] != 0; }) ||
          are_collinear(corners_of(soup, face))) {
        is_broken_[face] = 1;
      }
    }
  }

  const PreparedMesh& mesh_;
  const CutMesh& cut_;
  std::vector<std::uint8_t> is_broken_;
};

/// Unites components that intersect.
DisjointSets united_components(const PreparedMesh& mesh) {
  DisjointSets sets(mesh.components().count);
  const auto component = [&](Index face) {
    return mesh.components().of_face[mesh.cut().side.mesh_face(face)];
  };
  for (const IntersectingPair& pair : mesh.intersecting_pairs()) {
    sets.unite(component(pair.face_a), component(pair.face_b));
  }
  return sets;
}

void note_component(bool bounds_solid, BrokenSolid& solid) {
  solid.all_bound_solid = solid.all_bound_solid && bounds_solid;
  solid.any_bounds_solid = solid.any_bounds_solid || bounds_solid;
}

}  // namespace

std::vector<Index> find_broken_faces(const PreparedMesh& mesh) {
  return BrokenFaces(mesh).find();
}

std::vector<BrokenSolid> find_broken_solids(const PreparedMesh& mesh) {
  const std::vector<Index> broken_faces = find_broken_faces(mesh);
  if (broken_faces.empty()) return {};
  std::vector<std::uint8_t> is_broken(mesh.components().count, 0);
  for (const Index face : broken_faces) {
    is_broken[mesh.components().of_face[mesh.cut().side.mesh_face(face)]] = 1;
  }
  const std::vector<std::uint8_t> bounds = bounds_solid(mesh, mesh.components());
  DisjointSets sets = united_components(mesh);
  std::vector<BrokenSolid> solids;
  std::vector<Index> solid_of(mesh.components().count, kNoIndex);
  for (std::size_t f = 0; f < mesh.components().of_face.size(); ++f) {
    const Index component = mesh.components().of_face[f];
    if (is_broken[component] == 0) continue;
    Index& solid = solid_of[sets.find(component)];
    if (solid == kNoIndex) {
      solid = static_cast<Index>(solids.size());
      solids.emplace_back();
    }
    solids[solid].faces.push_back(mesh.cut().side.faces[f]);
    note_component(bounds[component] != 0, solids[solid]);
  }
  return solids;
}

BrokenSolid whole_mesh_as_solid(const PreparedMesh& mesh) {
  BrokenSolid whole;
  whole.faces = mesh.cut().side.faces;
  for (const std::uint8_t bounds : bounds_solid(mesh, mesh.components())) {
    note_component(bounds != 0, whole);
  }
  return whole;
}

}  // namespace meshalyzer
