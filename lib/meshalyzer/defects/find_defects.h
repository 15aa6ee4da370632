#pragma once

#include "meshalyzer/defects/defect.h"
#include "meshalyzer/defects/tolerances.h"
#include "meshalyzer/prepared/prepared_mesh.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace meshalyzer {

struct DefectOptions {
  /// What to look for.
  DefectCodes codes = DefectCodes::all();
  ToleranceOptions tolerances = {};
  /// List so many at most, 0: all. Counts are complete all the same.
  std::size_t max_defects = 0;
};

/// What is wrong with a mesh.
struct DefectReport {
  /// By code, then by lowest element.
  std::vector<Defect> defects;
  /// By code: how many there are, listed or not.
  std::array<std::size_t, kDefectCodes> counts{};
  /// As they were used.
  Tolerances tolerances;
  /// Sentences about inconsistent tolerances.
  std::vector<std::string> warnings;

  [[nodiscard]] std::size_t count(DefectCode code) const {
    return counts[static_cast<std::size_t>(code)];
  }
  [[nodiscard]] std::size_t total() const;
  /// Whether there are more defects than are listed.
  [[nodiscard]] bool is_cut() const { return total() > defects.size(); }
};

/// Finds all that is wrong with a mesh (contract 5).
///
/// The same for any number of threads. Where a position is not finite, the mesh is corrupt, and
/// nothing is looked for but corrupt, orphan-vertex and numbering.
///
/// @throws InvalidArgument  as resolve_tolerances().
/// @complexity  O(#F log #F) for meshes whose faces meet few others.
[[nodiscard]] DefectReport find_defects(const Soup& soup, const DefectOptions& options = {});

/// The same for a mesh that is already built, whose positions are finite.
[[nodiscard]] DefectReport find_defects(const PreparedMesh& mesh,
                                        const DefectOptions& options = {});

}  // namespace meshalyzer
