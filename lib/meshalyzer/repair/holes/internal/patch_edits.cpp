#include "meshalyzer/repair/holes/internal/patch_edits.h"

#include "meshalyzer/repair/holes/internal/patch_edges.h"

#include <cstddef>
#include <vector>

namespace meshalyzer {
namespace {

/// Returns, by face of the patch, the file face that it is like.
std::vector<Index> likes_of(const PreparedMesh& mesh, const HoleLoop& loop, const Patch& patch) {
  const CutMesh& cut = mesh.cut();
  const PatchEdges edges(patch);
  std::vector<Index> likes(patch.triangles.size(), kNoIndex);
  std::vector<Index> reached;
  const auto reach = [&](Index face, Index like) {
    if (face == kNoIndex || likes[face] != kNoIndex) return;
    likes[face] = like;
    reached.push_back(face);
  };
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (!loop.halfedges[i].is_valid()) continue;
    reach(edges.face_at({loop.vertices[i], loop.next(i)}),
          cut.side.face(cut.mesh.face_handle(loop.halfedges[i])));
  }
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const Triangle& t = patch.triangles[reached[i]];
    for (std::size_t k = 0; k < 3; ++k) {
      reach(edges.face_at({t[(k + 1) % 3], t[k]}), likes[reached[i]]);
    }
  }
  return likes;
}

}  // namespace

void add_patch(const PreparedMesh& mesh, const HoleLoop& loop, const Patch& patch, Edits& edits) {
  const auto n_vertices = static_cast<Index>(mesh.soup().n_vertices());
  const auto shift = static_cast<Index>(edits.added_vertices.size());
  const Index op = edits.begin_operation();
  for (const Vec3& position : patch.added) {
    edits.added_vertices.push_back({.op = op, .position = position});
  }
  const std::vector<Index> likes = likes_of(mesh, loop, patch);
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    Triangle corners = patch.triangles[i];
    for (Index& v : corners) v += v >= n_vertices ? shift : 0;
    edits.added_faces.push_back(
        {.op = op, .corners = corners, .like = likes[i], .fills_hole = true});
  }
}

}  // namespace meshalyzer
