#pragma once

#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/prepared/prepared_mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): the border edges of a mesh, and pairs of them.

/// A border edge in the direction of its face. Elements are named by index in the file.
struct WeldEdge {
  Index from = 0;
  Index to = 0;
  /// The corner of the face that is not on the edge.
  Index third = 0;
  Index face = 0;
};

/// The relative direction of two edges that are to become one.
enum class EdgeRun : std::uint8_t {
  /// The edges run against each other, as in a consistently oriented mesh.
  Opposite,
  Same,
};

/// Two border edges, by number, that are to become one.
struct WeldJoin {
  Index first = 0;
  Index second = 0;
  EdgeRun run = EdgeRun::Opposite;
  /// The larger of the distances between their ends.
  double distance = 0.0;
};

/// Returns the vertex of `second` that `first.from` (`first.to`) is merged with.
[[nodiscard]] inline Index partner_of_from(const WeldEdge& second, EdgeRun run) {
  return run == EdgeRun::Opposite ? second.to : second.from;
}
[[nodiscard]] inline Index partner_of_to(const WeldEdge& second, EdgeRun run) {
  return run == EdgeRun::Opposite ? second.from : second.to;
}

/// Returns the border edges of a mesh, except those of faces with two corners at one position:
/// welding would remove such faces, which is the task of other passes.
///
/// @return The edges in order of the mesh's edges.
[[nodiscard]] std::vector<WeldEdge> find_weld_edges(const PreparedMesh& mesh);

/// Returns the lowest end of one of these edges at the place of each end.
///
/// @return     #V: the representative; kNoIndex for vertices that are no ends.
/// @complexity O(#V + #edges).
[[nodiscard]] std::vector<Index> find_weld_places(std::span<const Vec3> positions,
                                                  std::span<const WeldEdge> edges);

/// Returns the edges at each place, ascending, by the vertex that names it.
///
/// @param wanted  The edges to list, by number, ascending.
/// @param places  The places as find_weld_places() returns them.
[[nodiscard]] ItemsByGroup list_edges_at_places(std::span<const WeldEdge> edges,
                                                std::span<const Index> wanted,
                                                std::span<const Index> places);

}  // namespace meshalyzer
