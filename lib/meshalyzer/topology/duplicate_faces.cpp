#include "meshalyzer/topology/duplicate_faces.h"

#include "meshalyzer/base/sort_unique.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns the file vertex opposite to a half-edge in its face.
Index opposite_vertex(const CutMesh& cut, HalfedgeHandle h) {
  return cut.side.vertex(cut.mesh.to_vertex_handle(cut.mesh.next_halfedge_handle(h)));
}

/// Collects the duplicates among the faces at edges of the complex, each met up to three times.
class DuplicateCollector {
 public:
  explicit DuplicateCollector(const CutMesh& cut) : cut_(cut) {}

  void compare_two(HalfedgeHandle a, HalfedgeHandle b) {
    if (opposite_vertex(cut_, a) != opposite_vertex(cut_, b)) return;
    duplicates_.push_back(std::max(cut_.mesh.face_handle(a), cut_.mesh.face_handle(b)));
  }

  void compare_all(std::span<const HalfedgeHandle> halfedges) {
    round_.clear();
    for (const HalfedgeHandle h : halfedges) {
      round_.emplace_back(opposite_vertex(cut_, h), cut_.mesh.face_handle(h));
    }
    std::sort(round_.begin(), round_.end());
    for (std::size_t i = 1; i < round_.size(); ++i) {
      if (round_[i].first == round_[i - 1].first) duplicates_.push_back(round_[i].second);
    }
  }

  [[nodiscard]] std::vector<FaceHandle> take() {
    sort_unique(duplicates_);
    return std::move(duplicates_);
  }

 private:
  const CutMesh& cut_;
  std::vector<FaceHandle> duplicates_;
  std::vector<std::pair<Index, FaceHandle>> round_;
};

}  // namespace

std::vector<FaceHandle> find_duplicate_faces(const CutMesh& cut) {
  const TriMesh& mesh = cut.mesh;
  DuplicateCollector collector(cut);
  for (const EdgeHandle e : mesh.all_edges()) {
    if (mesh.is_boundary(e)) continue;
    collector.compare_two(mesh.halfedge_handle(e, 0), mesh.halfedge_handle(e, 1));
  }
  const CutEdges& flipped = cut.side.flipped_edges;
  for (std::size_t i = 0; i < flipped.size(); ++i) collector.compare_all(flipped[i].halfedges);
  const CutEdges& crowded = cut.side.non_manifold_edges;
  for (std::size_t i = 0; i < crowded.size(); ++i) collector.compare_all(crowded[i].halfedges);
  return collector.take();
}

}  // namespace meshalyzer
