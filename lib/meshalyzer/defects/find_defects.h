#pragma once

#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/defects/defect_list.h"
#include "meshalyzer/defects/tolerances.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/spatial/pair_limits.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace meshalyzer {

/// The options of find_defects(): what to search, and how much to list.
struct DefectOptions {
  /// The codes to search for.
  DefectCodes codes = DefectCodes::all();
  ToleranceOptions tolerances = {};
  /// The largest number of defects that are listed; 0 lists all. Counts are complete in any case.
  std::size_t max_defects = 0;
  /// The limits of the search for intersecting faces; a prepared mesh has limits of its own.
  PairLimits pairs = {};
  /// Called now and then by the search for foldovers, which ends once it returns true.
  StopQuery wants_to_stop = {};
};

/// The defects of a mesh.
struct DefectReport {
  /// Sorted by code, then by lowest element.
  DefectList defects;
  /// The number of defects of each code, whether they are listed or not.
  std::array<std::size_t, kDefectCodes> counts{};
  /// The tolerances that the finders used.
  Tolerances tolerances;
  /// Sentences that say which tolerances contradict each other, and which searches ended before
  /// they had found all (PairLimits, DefectOptions::wants_to_stop).
  std::vector<std::string> warnings;
  /// The codes of which there may be more defects, because a search ended early.
  DefectCodes unfinished;

  [[nodiscard]] std::size_t count(DefectCode code) const {
    return counts[static_cast<std::size_t>(code)];
  }
  /// Returns the number of defects of some codes.
  [[nodiscard]] std::size_t count(const DefectCodes& codes) const;
  /// Tells whether there may be more defects of some codes than were found.
  [[nodiscard]] bool may_have_more(const DefectCodes& codes) const;
  /// Returns the number of all defects, whether they are listed or not.
  [[nodiscard]] std::size_t total() const;
  /// Tells whether there are more defects than are listed.
  [[nodiscard]] bool is_cut() const { return total() > defects.size(); }
};

/// Finds the defects of a mesh (doc/defects.md).
///
/// The result does not depend on the number of threads. A mesh with a position that is not finite
/// is only searched for corrupt records, orphan vertices and breaks of the numbering.
///
/// @throws InvalidArgument  as resolve_tolerances() and build().
/// @complexity  O(#F log #F) for meshes whose faces meet few others.
[[nodiscard]] DefectReport find_defects(const Soup& soup, const DefectOptions& options = {});

/// Finds the defects of a prepared mesh.
[[nodiscard]] DefectReport find_defects(const PreparedMesh& mesh,
                                        const DefectOptions& options = {});

}  // namespace meshalyzer
