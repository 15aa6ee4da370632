#include "meshalyzer/repair/replace/internal/broken_solids.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/repair/orient/bounds_solid.h"

#include <algorithm>
#include <cstdint>

namespace meshalyzer {
namespace {

/// Marks the components that are broken.
class BrokenComponents {
 public:
  explicit BrokenComponents(const PreparedMesh& mesh)
      : mesh_(mesh), cut_(mesh.cut()), is_broken_(mesh.components().count) {}

  std::vector<std::uint8_t> find() {
    // If the complex is not manifold or not consistently oriented, the cut mesh has borders too.
    for (const HalfedgeHandle h : cut_.mesh.halfedges()) {
      const HalfedgeHandle opposite = cut_.mesh.opposite_halfedge_handle(h);
      if (!cut_.mesh.is_boundary(h) && cut_.mesh.is_boundary(opposite)) {
        mark(cut_.mesh.face_handle(h));
      }
    }
    for (const FaceHandle f : cut_.mesh.faces()) {
      if (has_no_area(f)) mark(f);
    }
    for (const IntersectingPair& pair : mesh_.intersecting_pairs()) {
      for (const Index face : {pair.face_a, pair.face_b}) {
        is_broken_[mesh_.components().of_face[cut_.side.mesh_face(face)]] = 1;
      }
    }
    mark_pinched();
    return std::move(is_broken_);
  }

 private:
  void mark(FaceHandle f) {
    is_broken_[mesh_.components().of_face[static_cast<std::size_t>(f.idx())]] = 1;
  }

  [[nodiscard]] bool has_no_area(FaceHandle f) const {
    const auto [a, b, c] = corners_of(mesh_.soup(), cut_.side.face(f));
    return accurate_normal(a, b, c).isZero(0.0);
  }

  /// Copies of one vertex belong to one component, so that examining the first suffices.
  void mark_pinched() {
    for (const Index v : cut_.side.non_manifold_vertices) {
      const VertexHandle vertex(static_cast<int>(v));
      for (const FaceHandle f : cut_.mesh.vf_range(vertex)) mark(f);
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

std::vector<BrokenSolid> find_broken_solids(const PreparedMesh& mesh) {
  const std::vector<std::uint8_t> is_broken = BrokenComponents(mesh).find();
  if (std::find(is_broken.begin(), is_broken.end(), 1) == is_broken.end()) return {};
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
