#include "meshalyzer/repair/holes/internal/hole_loop.h"

#include "meshalyzer/defects/boundary_chains.h"
#include "meshalyzer/spatial/triangle_distance.h"
#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace meshalyzer {
namespace {

using Ends = std::array<Index, 2>;

/// The border edges of a complex, by their two vertices.
class BorderHalfedges {
 public:
  explicit BorderHalfedges(const CutMesh& cut) : cut_(cut), edges_(find_border_edges(cut)) {}

  /// Returns the inner half-edge of the border edge between two vertices.
  [[nodiscard]] HalfedgeHandle find(const Ends& ends) const {
    const auto [low, high] = std::minmax(ends[0], ends[1]);
    const auto is_before = [&](HalfedgeHandle h, const Ends& e) {
      return ascending_file_ends(cut_, h) < e;
    };
    return *std::lower_bound(edges_.begin(), edges_.end(), Ends{low, high}, is_before);
  }

 private:
  const CutMesh& cut_;
  std::vector<HalfedgeHandle> edges_;
};

/// Returns the chain in reverse, with the half-edges of its edges.
HoleLoop make_loop(const BoundaryChain& chain, const BorderHalfedges& border) {
  HoleLoop loop;
  loop.vertices.assign(chain.vertices.rbegin(), chain.vertices.rend());
  const std::size_t n_edges = chain.is_closed ? loop.size() : loop.size() - 1;
  loop.halfedges.reserve(n_edges);
  for (std::size_t i = 0; i < n_edges; ++i) {
    loop.halfedges.push_back(border.find({loop.vertices[i], loop.next(i)}));
  }
  return loop;
}

/// Tells whether all faces beyond have the same direction along their edges, as seen on a walk
/// round the loop.
bool runs_one_way(const CutMesh& cut, const HoleLoop& loop) {
  for (std::size_t i = 0; i < loop.halfedges.size(); ++i) {
    if (file_ends(cut, loop.halfedges[i])[1] != loop.vertices[i]) return false;
  }
  return true;
}

/// Returns the reason why a chain cannot be filled; empty if it can.
std::string objection(const CutMesh& cut, const BoundaryChain& chain, const HoleLoop& loop) {
  if (!chain.is_closed) return "it ends at an edge with more than two faces";
  if (loop.size() < 3) return "it is a slit of two edges";
  if (!runs_one_way(cut, loop)) return "the faces round it are not oriented consistently";
  return {};
}

}  // namespace

HoleLoops find_hole_loops(const PreparedMesh& mesh) {
  HoleLoops result;
  const std::vector<BoundaryChain> chains = find_boundary_chains(mesh);
  if (chains.empty()) return result;
  const BorderHalfedges border(mesh.cut());
  for (const BoundaryChain& chain : chains) {
    HoleLoop loop = make_loop(chain, border);
    std::string reason = objection(mesh.cut(), chain, loop);
    if (reason.empty()) {
      result.loops.push_back(std::move(loop));
    } else {
      result.refused.push_back(refuse_hole(mesh, loop, std::move(reason)));
    }
  }
  return result;
}

Refusal refuse_hole(const PreparedMesh& mesh, const HoleLoop& loop, std::string reason) {
  Refusal refusal{.code = DefectCode::Hole,
                  .vertex = *std::min_element(loop.vertices.begin(), loop.vertices.end()),
                  .face = kNoIndex,
                  .reason = std::move(reason)};
  for (const HalfedgeHandle h : loop.halfedges) {
    if (!h.is_valid()) continue;
    refusal.face = std::min(refusal.face, mesh.cut().side.face(mesh.cut().mesh.face_handle(h)));
  }
  return refusal;
}

double length_of(const Soup& soup, const HoleLoop& loop) {
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    length += (soup.positions[loop.next(i)] - soup.positions[loop.vertices[i]]).norm();
  }
  return length;
}

double distance_from(const Soup& soup, const HoleLoop& loop, const Vec3& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3& a = soup.positions[loop.vertices[i]];
    const Vec3& b = soup.positions[loop.next(i)];
    nearest = std::min(nearest, distance_from_segment(a, b, point));
  }
  return nearest;
}

}  // namespace meshalyzer
