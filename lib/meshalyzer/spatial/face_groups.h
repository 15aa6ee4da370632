#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/spatial/face_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// Groups of very many faces at one place that intersect the same other faces in the same way. One
/// face represents its group, so that pairs can be counted instead of searched one by one.
///
/// A group consists of faces with the same three vertices, or of faces at the same three places
/// each of which shares no vertex with any other face.
class FaceGroups {
 public:
  /// @complexity O(#F) time if there are none: only faces whose box equals that of another face of
  ///             their leaf are examined.
  FaceGroups(const CutMesh& cut, const FaceTree& tree);

  /// Returns the number of groups.
  [[nodiscard]] std::size_t size() const { return groups_.size(); }
  [[nodiscard]] std::span<const Index> faces(std::size_t group) const {
    return groups_[group].faces;
  }
  /// Returns the slots of two faces of a group, the first of which represents it.
  [[nodiscard]] std::array<std::size_t, 2> two_slots(std::size_t group) const {
    return groups_[group].slots;
  }

  /// Returns the faces that the face at a slot represents, including itself; empty if it is in no
  /// group. The slot must not be one that is left out.
  [[nodiscard]] std::span<const Index> faces_at(std::size_t slot) const;

  /// Returns the lanes of a leaf whose faces are represented by others.
  [[nodiscard]] unsigned left_out(std::size_t leaf) const {
    return left_out_.empty() ? 0U : left_out_[leaf];
  }

 private:
  struct Group {
    std::array<std::size_t, 2> slots;
    std::vector<Index> faces;
  };

  void add(const CutMesh& cut, const FaceTree& tree, std::span<const Index> slots);

  /// The groups, ascending by first slot.
  std::vector<Group> groups_;
  /// #leaves: the represented lanes as bits; empty if there are no groups.
  std::vector<std::uint8_t> left_out_;
};

}  // namespace meshalyzer
