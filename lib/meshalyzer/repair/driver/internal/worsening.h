#pragma once

#include "meshalyzer/repair/driver/defect_counts.h"
#include "meshalyzer/repair/driver/internal/defect_inventory.h"

#include <vector>

namespace meshalyzer {

// What a whole repair may not do: end with a mesh that is worse than the input.

/// Returns the kinds of which there are more after a repair than before.
[[nodiscard]] std::vector<CountRise> find_rises(const DefectInventory& before,
                                                const DefectInventory& after);

/// What makes a mesh worse than it was.
struct Worsening {
  /// The kinds that rise and may not, or by whose elements an attribute is lost.
  std::vector<CountedDefect> kinds;
  /// The attributes that were yes and are not any more.
  std::vector<Attribute> lost;

  [[nodiscard]] bool empty() const { return kinds.empty() && lost.empty(); }
};

/// Compares a mesh before and after a repair: no attribute that was yes may be lost, and no count
/// may rise. The exception: each non-manifold edge that is parted may leave one border edge and one
/// pinched vertex, since one of an odd number of faces has no partner.
[[nodiscard]] Worsening find_worsening(const DefectInventory& before, const DefectInventory& after);

/// Returns the elements that have made a mesh worse: those of the kinds that rise which the mesh
/// did not have before, and among border edges first those that were no non-manifold edges.
[[nodiscard]] std::vector<CountedElement> find_new_elements(const DefectInventory& before,
                                                            const DefectInventory& after,
                                                            const Worsening& worsening);

}  // namespace meshalyzer
