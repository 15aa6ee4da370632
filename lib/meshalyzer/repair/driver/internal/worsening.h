#pragma once

#include "meshalyzer/repair/driver/defect_counts.h"
#include "meshalyzer/repair/driver/internal/defect_inventory.h"

#include <vector>

namespace meshalyzer {

// The rule for a whole repair: it may not end with a mesh that is worse than the input.

/// Returns the kinds of defective elements that are more numerous after a repair than before.
[[nodiscard]] std::vector<CountRise> find_rises(const DefectInventory& before,
                                                const DefectInventory& after);

/// The respects in which a mesh is worse than it was.
struct Worsening {
  /// The kinds whose count rises and may not, or whose elements cost the mesh an attribute.
  std::vector<CountedDefect> kinds;
  /// The attributes that the mesh had and has lost.
  std::vector<Attribute> lost;

  [[nodiscard]] bool empty() const { return kinds.empty() && lost.empty(); }
};

/// Compares a mesh before and after a repair: no attribute may be lost, and no count may rise.
/// There are two exceptions. Each non-manifold edge that is split may leave one border edge and one
/// pinched vertex, since one of an odd number of faces has no partner. If intersecting pairs become
/// fewer, sheets may end where they were cut, with border edges that may be those of slits.
[[nodiscard]] Worsening find_worsening(const DefectInventory& before, const DefectInventory& after);

/// Returns the elements that have made a mesh worse: those of the rising kinds that the mesh did
/// not have before. Border edges that were no non-manifold edges come before those that were.
[[nodiscard]] std::vector<CountedElement> find_new_elements(const DefectInventory& before,
                                                            const DefectInventory& after,
                                                            const Worsening& worsening);

}  // namespace meshalyzer
