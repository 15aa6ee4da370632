#include "meshalyzer/topology/duplicate_faces.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"

#include <algorithm>
#include <span>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns the file vertex opposite to a half-edge in its face.
Index opposite_vertex(const CutMesh& cut, HalfedgeHandle h) {
  return cut.side.vertex(cut.mesh.opposite_vh(h));
}

/// Returns the higher of the two faces of an inner edge if they have the same vertices.
FaceHandle duplicate_at(const CutMesh& cut, EdgeHandle e) {
  const HalfedgeHandle a = cut.mesh.halfedge_handle(e, 0);
  const HalfedgeHandle b = cut.mesh.halfedge_handle(e, 1);
  if (cut.mesh.is_boundary(e) || opposite_vertex(cut, a) != opposite_vertex(cut, b)) {
    return FaceHandle();
  }
  return std::max(cut.mesh.face_handle(a), cut.mesh.face_handle(b));
}

/// Appends all faces at a cut edge but the lowest of each set with the same vertices.
void append_duplicates_at(const CutMesh& cut, std::span<const HalfedgeHandle> halfedges,
                          std::vector<FaceHandle>& duplicates) {
  std::vector<std::pair<Index, FaceHandle>> round;
  for (const HalfedgeHandle h : halfedges) {
    round.emplace_back(opposite_vertex(cut, h), cut.mesh.face_handle(h));
  }
  std::sort(round.begin(), round.end());
  for (std::size_t i = 1; i < round.size(); ++i) {
    if (round[i].first == round[i - 1].first) duplicates.push_back(round[i].second);
  }
}

}  // namespace

std::vector<FaceHandle> find_duplicate_faces(const CutMesh& cut) {
  // A face may be met at each of its edges.
  auto duplicates = collect_chunks<FaceHandle>(
      cut.mesh.n_edges(), [&](Chunk edges, std::vector<FaceHandle>& found) {
        for (std::size_t e = edges.begin; e < edges.end; ++e) {
          const FaceHandle face = duplicate_at(cut, EdgeHandle(static_cast<int>(e)));
          if (face.is_valid()) found.push_back(face);
        }
      });
  for (const CutEdges* edges : {&cut.side.flipped_edges, &cut.side.non_manifold_edges}) {
    for (std::size_t i = 0; i < edges->size(); ++i) {
      append_duplicates_at(cut, (*edges)[i].halfedges, duplicates);
    }
  }
  sort_unique(duplicates);
  return duplicates;
}

}  // namespace meshalyzer
