#pragma once

#include "meshalyzer/analysis/analysis.h"

#include <cstdint>

namespace meshalyzer {

/// Returns an id in the place of the index of its record.
[[nodiscard]] constexpr Index id_in_place_of_record(std::int32_t id) {
  return static_cast<Index>(id);
}

/// Converts an analysis that has ids in the place of its records (id_in_place_of_record()): it gets
/// tables of the ids that occur, ascending, and indices into these.
///
/// The tables ascend, so that lists stay ascending if the ids of the file do; records with the same
/// id become one.
void index_records(Analysis& analysis);

}  // namespace meshalyzer
