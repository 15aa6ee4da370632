#pragma once

#include "meshalyzer/spatial/corner_angles.h"
#include "meshalyzer/spatial/face_tree.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// A vertex of the faces of one leaf.
struct LeafVertex {
  Index vertex = kNoIndex;
  /// The faces that have it, as bits.
  unsigned lanes = 0;
  /// The numbers of their corners there, two bits each.
  unsigned corners = 0;
  /// A range of angles that holds those of all these corners (see CornerAngles); known of hubs
  /// only.
  AngleRange angles;

  [[nodiscard]] std::size_t corner(std::size_t lane) const { return corners >> (2 * lane) & 3U; }
};

/// Tells which leaves of a FaceTree have vertices in common, so that the vertices of their faces
/// need not be compared where there is none. That pays where the boxes of very many leaves meet.
/// A hub is a vertex of very many leaves.
class SharedVertices {
 public:
  /// @complexity O(#F) time; some 12 bytes a face.
  SharedVertices(const FaceTree& tree, const CornerAngles& angles);

  /// Returns the hubs of a leaf, ascending.
  [[nodiscard]] std::span<const LeafVertex> hubs(std::size_t leaf) const {
    return part_of(hubs_, hub_begin_, leaf);
  }
  /// Returns the leaves that have a vertex in common with a leaf that is no hub, ascending; a leaf
  /// with no other vertices than hubs has none.
  [[nodiscard]] std::span<const Index> neighbours(std::size_t leaf) const {
    return part_of(neighbours_, neighbour_begin_, leaf);
  }

 private:
  template <typename Item>
  static std::span<const Item> part_of(const std::vector<Item>& all,
                                       const std::vector<std::size_t>& begin, std::size_t leaf) {
    return std::span(all).subspan(begin[leaf], begin[leaf + 1] - begin[leaf]);
  }

  std::vector<LeafVertex> hubs_;
  std::vector<std::size_t> hub_begin_;
  std::vector<Index> neighbours_;
  std::vector<std::size_t> neighbour_begin_;
};

}  // namespace meshalyzer
