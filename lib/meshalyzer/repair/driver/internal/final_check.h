#pragma once

#include "meshalyzer/defects/tolerances.h"
#include "meshalyzer/repair/driver/internal/defect_inventory.h"
#include "meshalyzer/repair/driver/internal/repair_state.h"
#include "meshalyzer/repair/driver/options.h"

#include <cstdint>

namespace meshalyzer {

/// Tells whether a file can hold two vertices at one position.
enum class EqualPoints : std::uint8_t {
  Stay,
  /// They are one vertex in the file, because STL names no vertices.
  Merge,
};

/// The file that will hold a mesh, and the kinds of contact that count.
struct FinalCheck {
  EqualPoints equal_points = EqualPoints::Stay;
  UnweldedPairs unwelded = UnweldedPairs::Count;
};

/// @param input  The format of the input.
[[nodiscard]] FinalCheck final_check_for(const RepairOptions& options, Format input);

/// Lists the defective elements of a mesh as its file will hold it.
[[nodiscard]] DefectInventory list_defective_in_file(const RepairState& state,
                                                     const Tolerances& tolerances,
                                                     const FinalCheck& check);

/// Tells whether a mesh is good as its file will hold it, except for the numbers of its records.
[[nodiscard]] bool is_good_in_file(const RepairState& state, const Tolerances& tolerances,
                                   const FinalCheck& check);

}  // namespace meshalyzer
