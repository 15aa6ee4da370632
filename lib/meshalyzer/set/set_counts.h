#pragma once

#include "meshalyzer/analysis/field_info.h"
#include "meshalyzer/set/set_analysis.h"

#include <array>
#include <cstddef>

namespace meshalyzer {

/// A count that is summed over the meshes of a set.
struct SetCount {
  FieldInfo info;
  std::size_t SetAnalysis::*total;
  std::size_t Characteristics::*of_mesh;
  Known known = Known::Always;
  /// The member that tells whether the total is only a lower bound, because a search was stopped;
  /// null if it always is exact.
  bool SetAnalysis::*is_at_least = nullptr;

  /// Tells whether the total of a set is only a lower bound.
  [[nodiscard]] constexpr bool is_at_least_of(const SetAnalysis& set) const {
    return is_at_least != nullptr && set.*is_at_least;
  }
};

/// One row for each count, in the order of reports.
inline constexpr std::array kSetCounts{
    SetCount{{.key = "vertices", .label = "vertices"},
             &SetAnalysis::vertices,
             &Characteristics::vertices},
    SetCount{{.key = "faces", .label = "faces"}, &SetAnalysis::faces, &Characteristics::faces},
    SetCount{{.key = "edges", .label = "edges"}, &SetAnalysis::edges, &Characteristics::edges},
    SetCount{{.key = "components", .label = "components"},
             &SetAnalysis::components,
             &Characteristics::components},
    SetCount{{.key = "boundaries", .label = "boundaries"},
             &SetAnalysis::boundaries,
             &Characteristics::boundaries},
    SetCount{{.key = "intersecting_pairs_within",
              .label = "intersecting pairs within meshes",
              .definition = "those of each mesh with itself, summed"},
             &SetAnalysis::intersecting_pairs_within,
             &Characteristics::intersecting_pairs,
             Known::Measured,
             &SetAnalysis::is_search_within_stopped},
};

}  // namespace meshalyzer
