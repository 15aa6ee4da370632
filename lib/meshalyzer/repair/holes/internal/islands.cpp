#include "meshalyzer/repair/holes/internal/islands.h"

#include "meshalyzer/spatial/closest_point.h"

#include <algorithm>

namespace meshalyzer {
namespace {

/// The maximum distance of a loop from a patch that it lies on, as a fraction of the diagonal of
/// the patch's loop.
constexpr double kReach = 1e-3;

std::vector<Box3> boxes_of(const Soup& soup, std::span<const HoleLoop> loops) {
  std::vector<Box3> boxes(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (const Index v : loops[i].vertices) boxes[i].extend(soup.positions[v]);
  }
  return boxes;
}

}  // namespace

Islands::Islands(const PreparedMesh& mesh, std::span<const HoleLoop> loops)
    : mesh_(mesh), loops_(loops), boxes_(boxes_of(mesh.soup(), loops)), tree_(boxes_) {}

double Islands::reach_of(std::size_t loop) const {
  return kReach * boxes_[loop].diagonal().stableNorm();
}

std::vector<Index> Islands::candidates(std::size_t loop) const {
  Box3 room = boxes_[loop];
  room.min().array() -= reach_of(loop);
  room.max().array() += reach_of(loop);
  std::vector<Index> found = tree_.meeting(room);
  std::erase_if(found, [&](Index i) { return i == loop || !room.contains(boxes_[i]); });
  return found;
}

std::vector<std::size_t> Islands::lying_on(const Patch& patch, std::size_t of_loop) const {
  std::vector<std::size_t> found;
  const PatchSoup own = make_soup(mesh_.soup(), patch);
  const CutMesh cut = build(own.soup);
  const FaceTree faces(cut);
  const ClosestPoints closest(faces);
  const double reach = reach_of(of_loop);
  for (const Index i : candidates(of_loop)) {
    const auto& vertices = loops_[i].vertices;
    if (std::all_of(vertices.begin(), vertices.end(), [&](Index v) {
          return closest.find({.point = mesh_.soup().positions[v], .within = reach}).has_value();
        })) {
      found.push_back(i);
    }
  }
  return found;
}

std::vector<std::size_t> Islands::along(std::span<const Index> faces, std::size_t of_loop) const {
  std::vector<std::size_t> found;
  if (faces.empty()) return found;
  const CutMesh& cut = mesh_.cut();
  for (const Index i : candidates(of_loop)) {
    const auto& halfedges = loops_[i].halfedges;
    if (std::any_of(halfedges.begin(), halfedges.end(), [&](HalfedgeHandle h) {
          return std::binary_search(faces.begin(), faces.end(),
                                    cut.side.face(cut.mesh.face_handle(h)));
        })) {
      found.push_back(i);
    }
  }
  return found;
}

}  // namespace meshalyzer
