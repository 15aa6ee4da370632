#include "meshalyzer/repair/folds/fold_star.h"

#include "meshalyzer/repair/sort_unique.h"

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

/// Sides of the faces with none of them beyond, in order of the vertex they run from.
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

std::optional<FoldStar> star_of(const CutMesh& cut, std::span<const Index> vertices) {
  FoldStar star;
  for (const Index v : vertices) {
    for (const FaceHandle f : cut.mesh.vf_range(handle(v))) {
      star.faces.push_back(static_cast<Index>(f.idx()));
    }
  }
  sort_unique(star.faces);
  star.outline = outline_of(cut.mesh, star.faces);
  if (star.outline.size() < 3) return std::nullopt;
  // A disc, by V - E + F = 1 with 3 F = 2 E - n for n edges round it.
  const std::size_t inside = count_vertices(cut.mesh, star.faces) - star.outline.size();
  const bool is_disc = star.faces.size() + 2 == star.outline.size() + 2 * inside;
  if (!is_disc || inside != vertices.size()) return std::nullopt;
  return star;
}

}  // namespace meshalyzer
