#include "meshalyzer/repair/folds/internal/face_disc.h"

#include "meshalyzer/base/sort_unique.h"

#include <algorithm>

namespace meshalyzer {
namespace {

VertexHandle handle(Index vertex) {
  return VertexHandle(static_cast<int>(vertex));
}

std::size_t count_vertices(const TriMesh& mesh, std::span<const Index> faces) {
  std::vector<Index> vertices;
  for (const Index f : faces) {
    for (const VertexHandle v : mesh.fv_range(FaceHandle(static_cast<int>(f)))) {
      vertices.push_back(static_cast<Index>(v.idx()));
    }
  }
  sort_unique(vertices);
  return vertices.size();
}

/// Returns the sides of the faces with none of them beyond, in order of their first vertices.
std::vector<HalfedgeHandle> sides_of(const TriMesh& mesh, std::span<const Index> faces) {
  std::vector<HalfedgeHandle> sides;
  for (const Index f : faces) {
    for (const HalfedgeHandle h : mesh.fh_range(FaceHandle(static_cast<int>(f)))) {
      const FaceHandle beyond = mesh.opposite_face_handle(h);
      if (!beyond.is_valid() ||
          !std::binary_search(faces.begin(), faces.end(), static_cast<Index>(beyond.idx()))) {
        sides.push_back(h);
      }
    }
  }
  std::sort(sides.begin(), sides.end(), [&](HalfedgeHandle a, HalfedgeHandle b) {
    return mesh.from_vertex_handle(a) < mesh.from_vertex_handle(b);
  });
  return sides;
}

}  // namespace

bool is_inner(const CutMesh& cut, Index vertex) {
  const std::vector<Index>& not_manifold = cut.side.non_manifold_vertices;
  return !cut.mesh.is_boundary(handle(vertex)) &&
         !std::binary_search(not_manifold.begin(), not_manifold.end(), vertex);
}

std::vector<HalfedgeHandle> outline_of(const TriMesh& mesh, std::span<const Index> faces) {
  const std::vector<HalfedgeHandle> sides = sides_of(mesh, faces);
  std::vector<HalfedgeHandle> outline;
  if (sides.empty()) return outline;
  const auto from = [&](HalfedgeHandle h) { return mesh.from_vertex_handle(h); };
  HalfedgeHandle at = sides.front();
  do {
    outline.push_back(at);
    const VertexHandle to = mesh.to_vertex_handle(at);
    const auto next = std::partition_point(sides.begin(), sides.end(),
                                           [&](HalfedgeHandle h) { return from(h) < to; });
    if (next == sides.end() || from(*next) != to) return {};
    if (next + 1 != sides.end() && from(*(next + 1)) == to) return {};
    at = *next;
  } while (at != sides.front() && outline.size() < sides.size());
  if (outline.size() < sides.size()) outline.clear();
  return outline;
}

std::optional<FaceDisc> find_disc(const CutMesh& cut, std::span<const Index> vertices) {
  FaceDisc disc;
  for (const Index v : vertices) {
    for (const FaceHandle f : cut.mesh.vf_range(handle(v))) {
      disc.faces.push_back(static_cast<Index>(f.idx()));
    }
  }
  sort_unique(disc.faces);
  disc.outline = outline_of(cut.mesh, disc.faces);
  if (disc.outline.size() < 3) return std::nullopt;
  // A disc satisfies V - E + F = 1, with 3 F = 2 E - n for n edges of its outline.
  const std::size_t inside = count_vertices(cut.mesh, disc.faces) - disc.outline.size();
  const bool is_disc = disc.faces.size() + 2 == disc.outline.size() + 2 * inside;
  if (!is_disc || inside != vertices.size()) return std::nullopt;
  return disc;
}

std::vector<Index> faces_around(const CutMesh& cut, const FaceDisc& disc) {
  std::vector<Index> around;
  for (const HalfedgeHandle h : disc.outline) {
    for (const FaceHandle f : cut.mesh.vf_range(cut.mesh.from_vertex_handle(h))) {
      const auto face = static_cast<Index>(f.idx());
      if (!std::binary_search(disc.faces.begin(), disc.faces.end(), face)) around.push_back(face);
    }
  }
  sort_unique(around);
  return around;
}

bool reaches_border(const CutMesh& cut, std::span<const Index> faces) {
  return std::any_of(faces.begin(), faces.end(), [&](Index f) {
    for (const HalfedgeHandle h : cut.mesh.fh_range(FaceHandle(static_cast<int>(f)))) {
      if (cut.mesh.is_boundary(cut.mesh.opposite_halfedge_handle(h))) return true;
    }
    return false;
  });
}

bool has_one_crease(const CutMesh& cut, const std::vector<HalfedgeHandle>& outline) {
  std::size_t changes = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const HalfedgeHandle next = outline[(i + 1) % outline.size()];
    const auto is_border = [&](HalfedgeHandle h) {
      return cut.mesh.is_boundary(cut.mesh.opposite_halfedge_handle(h));
    };
    if (is_border(outline[i]) != is_border(next)) ++changes;
  }
  return changes == 2;
}

}  // namespace meshalyzer
