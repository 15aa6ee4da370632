#include "meshalyzer/set/set_object.h"

#include "meshalyzer/spatial/ray_parity.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {
namespace {

constexpr Index kSolid = 0;

SolidParts find_solids(const CutMesh& cut, const Components& components) {
  SolidParts solids{std::vector<std::uint8_t>(components.count, 1), components.of_face, 0};
  const std::vector<EdgeKind> kinds = classify_edges(cut);
  for (std::size_t e = 0; e < kinds.size(); ++e) {
    if (kinds[e] == EdgeKind::Border || kinds[e] == EdgeKind::NonManifold) {
      const HalfedgeHandle h = cut.mesh.halfedge_handle(EdgeHandle(static_cast<int>(e)), 0);
      solids.is_solid[components.of(cut.mesh, h)] = 0;
    }
  }
  for (Index& part : solids.of_face) {
    part = solids.is_solid[part] != 0 ? kSolid : kNoIndex;
  }
  solids.count = static_cast<std::size_t>(
      std::count(solids.is_solid.begin(), solids.is_solid.end(), std::uint8_t{1}));
  return solids;
}

std::vector<Index> first_vertices(const CutMesh& cut, const Components& components) {
  std::vector<Index> vertices(components.count, kNoIndex);
  for (std::size_t f = 0; f < cut.mesh.n_faces(); ++f) {
    Index& vertex = vertices[components.of_face[f]];
    if (vertex == kNoIndex) {
      const HalfedgeHandle h = cut.mesh.halfedge_handle(FaceHandle(static_cast<int>(f)));
      vertex = cut.side.vertex(cut.mesh.to_vertex_handle(h));
    }
  }
  return vertices;
}

std::shared_ptr<const PreparedMesh> prepared_without_records(const Soup& soup) {
  auto mesh = std::make_shared<PreparedMesh>(soup);
  mesh->release_soup();
  return mesh;
}

template <typename T>
std::uint64_t bytes_of(const std::vector<T>& items) {
  return items.size() * sizeof(T);
}

}  // namespace

SetObject::SetObject(const Soup& soup, ClosestUse use)
    : SetObject(prepared_without_records(soup), soup.vertex_ids, soup.face_ids, use) {}

SetObject::SetObject(std::shared_ptr<const PreparedMesh> mesh, Ids vertex_ids, Ids face_ids,
                     ClosestUse use)
    : mesh_(std::move(mesh)),
      use_(use),
      component_vertices_(first_vertices(cut(), components())),
      solids_(find_solids(cut(), components())),
      vertex_ids_(std::move(vertex_ids)),
      face_ids_(std::move(face_ids)) {
  for (const Box3& box : component_boxes()) {
    box_.extend(box);
  }
  static_cast<void>(tree());
}

std::vector<Index> SetObject::used_vertices() const {
  std::vector<std::uint8_t> is_met(cut().side.n_file_vertices, 0);
  std::vector<Index> vertices;
  for (std::size_t slot = 0; slot < tree().n_faces(); ++slot) {
    for (const Index v : tree().triangle(slot)) {
      if (std::exchange(is_met[v], 1) == 0) vertices.push_back(v);
    }
  }
  return vertices;
}

Side SetObject::side_of(const Vec3& point) const {
  if (!is_solid() || !box_.contains(point)) {
    return Side::Outside;
  }
  const PointLocation place = locate(tree(), {.of_face = solids_.of_face, .count = 1}, point);
  if (std::binary_search(place.on.begin(), place.on.end(), kSolid)) {
    return Side::OnSurface;
  }
  return std::binary_search(place.odd.begin(), place.odd.end(), kSolid) ? Side::Inside
                                                                        : Side::Outside;
}

std::uint64_t SetObject::bytes() const {
  // OpenMesh stores a point and a handle per vertex, two half-edges of three or four handles per
  // edge, and a handle per face; for the tree see FaceTree.
  constexpr std::uint64_t kVertex = 32;
  constexpr std::uint64_t kEdge = 40;
  constexpr std::uint64_t kFace = 56;
  const std::uint64_t closest =
      use_ == ClosestUse::Prepared ? ClosestPoints::bytes_for(cut().mesh.n_faces()) : 0;
  return cut().mesh.n_vertices() * kVertex + cut().mesh.n_edges() * kEdge +
         cut().mesh.n_faces() * kFace + bytes_of(cut().side.faces) +
         bytes_of(components().of_face) + bytes_of(solids_.of_face) + bytes_of(vertex_ids_.named) +
         bytes_of(face_ids_.named) + bytes_of(component_boxes()) + closest + sizeof(PreparedMesh) +
         sizeof(SetObject);
}

}  // namespace meshalyzer
