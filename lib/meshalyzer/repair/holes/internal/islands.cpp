#include "meshalyzer/repair/holes/internal/islands.h"

#include "meshalyzer/spatial/closest_point.h"

#include <algorithm>

namespace meshalyzer {
namespace {

/// The maximum distance of a loop from a patch that it lies on, as a fraction of the diagonal of
/// the patch's loop.
constexpr double kReach = 1e-3;
/// The same for a loop that faces the patch's loop.
constexpr double kReachOfFacing = 0.05;

std::vector<Box3> boxes_of(const Soup& soup, std::span<const HoleLoop> loops) {
  std::vector<Box3> boxes(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (const Index v : loops[i].vertices) boxes[i].extend(soup.positions[v]);
  }
  return boxes;
}

/// Returns the area that a loop runs round, as a vector normal to it, by whose direction it runs
/// counter-clockwise.
Vec3 vector_area(const Soup& soup, const HoleLoop& loop) {
  const Vec3& origin = soup.positions[loop.vertices.front()];
  Vec3 twice = Vec3::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3& from = soup.positions[loop.vertices[i]];
    twice += (from - origin).cross(soup.positions[loop.next(i)] - origin);
  }
  return 0.5 * twice;
}

}  // namespace

Islands::Islands(const PreparedMesh& mesh, std::span<const HoleLoop> loops)
    : mesh_(mesh), loops_(loops), boxes_(boxes_of(mesh.soup(), loops)), tree_(boxes_) {}

double Islands::share_of(std::size_t loop, double fraction) const {
  return fraction * boxes_[loop].diagonal().stableNorm();
}

std::vector<Index> Islands::candidates(std::size_t loop) const {
  return others_in(boxes_[loop], share_of(loop, kReach), loop);
}

std::vector<Index> Islands::others_in(Box3 box, double distance, std::size_t loop) const {
  box.min().array() -= distance;
  box.max().array() += distance;
  std::vector<Index> found = tree_.meeting(box);
  std::erase_if(found, [&](Index i) { return i == loop || !box.contains(boxes_[i]); });
  return found;
}

std::vector<std::size_t> Islands::within(double distance, const Patch& patch,
                                         std::span<const Index> loops) const {
  std::vector<std::size_t> found;
  if (loops.empty()) return found;
  const PatchSoup own = make_soup(mesh_.soup(), patch);
  const CutMesh cut = build(own.soup);
  const FaceTree faces(cut);
  const ClosestPoints closest(faces);
  for (const Index i : loops) {
    const auto& vertices = loops_[i].vertices;
    if (std::all_of(vertices.begin(), vertices.end(), [&](Index v) {
          return closest.find({.point = mesh_.soup().positions[v], .within = distance}).has_value();
        })) {
      found.push_back(i);
    }
  }
  return found;
}

std::vector<std::size_t> Islands::lying_on(const Patch& patch, std::size_t of_loop) const {
  return within(share_of(of_loop, kReach), patch, candidates(of_loop));
}

std::vector<std::size_t> Islands::facing(const Patch& patch, std::size_t of_loop) const {
  Box3 box = boxes_[of_loop];
  for (const Vec3& p : patch.added) box.extend(p);
  const double reach = share_of(of_loop, kReachOfFacing);
  std::vector<Index> loops = others_in(box, reach, of_loop);
  if (loops.empty()) return {};
  const Vec3 area = vector_area(mesh_.soup(), loops_[of_loop]);
  std::erase_if(loops,
                [&](Index i) { return !(area.dot(vector_area(mesh_.soup(), loops_[i])) < 0.0); });
  return within(reach, patch, loops);
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
