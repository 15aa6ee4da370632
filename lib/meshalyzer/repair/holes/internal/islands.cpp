#include "meshalyzer/repair/holes/internal/islands.h"

#include "meshalyzer/base/box.h"
#include "meshalyzer/repair/holes/internal/join_loops.h"
#include "meshalyzer/spatial/closest_point.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <limits>

namespace meshalyzer {
namespace {

/// The maximum distance of a loop from a patch that it lies on, as a fraction of the diagonal of
/// the patch's loop.
constexpr double kReach = 1e-3;
/// The same for a loop that faces the patch's loop.
constexpr double kReachOfFacing = 0.1;
/// The maximum number of pairs of vertices that are compared to find the gap between two loops.
constexpr std::size_t kMaxPairsOfGap = 10'000'000;
/// A way at less than 60 degrees to the faces beyond a border leads over them.
constexpr double kCosineOfOver = 0.5;

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

/// Returns the component of the faces beyond each loop.
std::vector<Index> components_beyond(const CutMesh& cut, std::span<const HoleLoop> loops) {
  const Components components = find_edge_components(cut);
  std::vector<Index> result;
  for (const HoleLoop& loop : loops) {
    result.push_back(components.of(cut.mesh, loop.halfedges.front()));
  }
  return result;
}

/// Tells whether the way from a corner of a loop to a point leads over the faces beyond, rather
/// than away from them, or across them, as at the rim of a wall.
bool leads_over_faces(const PreparedMesh& mesh, const HoleLoop& loop, std::size_t corner,
                      const Vec3& to) {
  const TriMesh& complex = mesh.cut().mesh;
  const Vec3& from = mesh.soup().positions[loop.vertices[corner]];
  Vec3 over_faces = Vec3::Zero();
  for (const std::size_t edge : {corner, (corner + loop.size() - 1) % loop.size()}) {
    const HalfedgeHandle h = complex.next_halfedge_handle(loop.halfedges[edge]);
    over_faces += (complex.point(complex.to_vertex_handle(h)) - from).stableNormalized();
  }
  return over_faces.stableNormalized().dot((to - from).stableNormalized()) > kCosineOfOver;
}

}  // namespace

Islands::Islands(const PreparedMesh& mesh, const ExistingEdges& existing,
                 std::span<const HoleLoop> loops)
    : mesh_(mesh),
      existing_(existing),
      loops_(loops),
      boxes_(boxes_of(mesh.soup(), loops)),
      components_(components_beyond(mesh.cut(), loops)),
      tree_(boxes_) {}

double Islands::share_of(std::size_t loop, double fraction) const {
  return fraction * boxes_[loop].diagonal().stableNorm();
}

std::vector<Index> Islands::candidates(std::size_t loop) const {
  return others_in(boxes_[loop], share_of(loop, kReach), loop);
}

std::vector<Index> Islands::others_in(const Box3& of_loop, double distance,
                                      std::size_t loop) const {
  const Box3 box = grown(of_loop, distance);
  std::vector<Index> found = tree_.meeting(box);
  std::erase_if(found, [&](Index i) { return i == loop || !box.contains(boxes_[i]); });
  return found;
}

bool Islands::run_against_each_other(std::size_t a, std::size_t b) const {
  const Soup& soup = mesh_.soup();
  return vector_area(soup, loops_[a]).dot(vector_area(soup, loops_[b])) < 0.0;
}

double Islands::length_of_gap(std::size_t outer, std::size_t inner) const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const HoleLoop& a = loops_[outer];
  const HoleLoop& b = loops_[inner];
  if (a.size() > kMaxPairsOfGap / b.size()) return kNone;
  const Bridge bridge = find_bridge(mesh_.soup(), existing_, a, b);
  if (!bridge.is_found()) return kNone;
  const std::vector<Vec3>& places = mesh_.soup().positions;
  const bool leads_over =
      leads_over_faces(mesh_, a, bridge.corner_a, places[b.vertices[bridge.corner_b]]) ||
      leads_over_faces(mesh_, b, bridge.corner_b, places[a.vertices[bridge.corner_a]]);
  return leads_over ? kNone : bridge.length;
}

bool Islands::has_nearer_outer_border(std::size_t loop, std::size_t outer) const {
  const double gap = length_of_gap(outer, loop);
  const std::vector<Index> near = tree_.meeting(grown(boxes_[loop], gap));
  return std::any_of(near.begin(), near.end(), [&](Index other) {
    return other != loop && other != outer && components_[other] != components_[loop] &&
           run_against_each_other(other, loop) && length_of_gap(other, loop) < gap;
  });
}

std::vector<std::size_t> Islands::inner_borders(std::span<const Index> loops, std::size_t of_loop,
                                                const Patch& patch, double distance) const {
  std::vector<std::size_t> found;
  if (loops.empty()) return found;
  const PatchSoup own = make_soup(mesh_.soup(), patch);
  const CutMesh cut = build(own.soup);
  const FaceTree faces(cut);
  const ClosestPoints closest(faces);
  for (const Index i : loops) {
    const auto& vertices = loops_[i].vertices;
    if (run_against_each_other(i, of_loop) &&
        std::all_of(vertices.begin(), vertices.end(),
                    [&](Index v) {
                      return closest.find({.point = mesh_.soup().positions[v], .within = distance})
                          .has_value();
                    }) &&
        !has_nearer_outer_border(i, of_loop)) {
      found.push_back(i);
    }
  }
  return found;
}

std::vector<std::size_t> Islands::lying_on(const Patch& patch, std::size_t of_loop) const {
  return inner_borders(candidates(of_loop), of_loop, patch, share_of(of_loop, kReach));
}

std::vector<std::size_t> Islands::facing(const Patch& patch, std::size_t of_loop) const {
  Box3 box = boxes_[of_loop];
  for (const Vec3& p : patch.added) box.extend(p);
  const double reach = share_of(of_loop, kReachOfFacing);
  return inner_borders(others_in(box, reach, of_loop), of_loop, patch, reach);
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
