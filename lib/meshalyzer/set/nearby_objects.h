#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/spatial/box_tree.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// Enumerates the objects of a set round one of them in order of distance, so that only near ones
/// are examined.
class NearbyObjects {
 public:
  struct Candidate {
    /// The distance between the boxes.
    double distance;
    /// The distance between the middles of the boxes. Among boxes that meet the object's own, those
    /// with a close middle are likely to be near.
    double distance_of_middles;
    Index object;
    auto operator<=>(const Candidate&) const = default;
  };

  /// @param boxes  The boxes of all objects, over which `tree` is built; that of the object itself
  ///               is not empty.
  NearbyObjects(Index object, std::span<const Box3> boxes, const BoxTree& tree);

  /// Returns the objects whose boxes are within `reach` of the object's own and that were not
  /// returned before, the nearest first.
  [[nodiscard]] std::vector<Candidate> within(double reach);

  /// Returns the distance within which all objects were returned; the others are at this distance
  /// or farther.
  [[nodiscard]] double given_up_to() const { return given_up_to_; }
  [[nodiscard]] bool all_given() const { return given_.size() == tree_.order().size(); }

 private:
  Index object_;
  std::span<const Box3> boxes_;
  const BoxTree& tree_;
  /// The objects that were returned, ascending; the object itself is among them.
  std::vector<Index> given_;
  double given_up_to_ = 0.0;
};

}  // namespace meshalyzer
