#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/spatial/box_tree.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// The objects of a set round one of them, shell by shell, so that of thousands only those are
/// looked at that are near.
class NearbyObjects {
 public:
  struct Candidate {
    /// From box to box.
    double distance;
    /// Of many boxes that meet the object's own those about the same middle are likely to be near.
    double distance_of_middles;
    Index object;
    auto operator<=>(const Candidate&) const = default;
  };

  /// @param boxes  Of all objects, `tree` is of; that of the object itself is not empty.
  NearbyObjects(Index object, std::span<const Box3> boxes, const BoxTree& tree);

  /// Those whose boxes are within `reach` of the object's own, but for those given before; the
  /// nearest first.
  [[nodiscard]] std::vector<Candidate> within(double reach);

  /// All objects not given yet are at this distance or farther.
  [[nodiscard]] double given_up_to() const { return given_up_to_; }
  [[nodiscard]] bool all_given() const { return given_.size() == tree_.order().size(); }

 private:
  Index object_;
  std::span<const Box3> boxes_;
  const BoxTree& tree_;
  /// Ascending; the object itself is among them.
  std::vector<Index> given_;
  double given_up_to_ = 0.0;
};

}  // namespace meshalyzer
