#pragma once

#include "meshalyzer/analysis/analysis.h"

#include <cstdint>

namespace meshalyzer {

/// Returns an id, put where the index of its record will stand.
[[nodiscard]] constexpr Index id_in_place_of_record(std::int32_t id) {
  return static_cast<Index>(id);
}

/// Gives an analysis that has ids in the place of its records, as from id_in_place_of_record(),
/// tables of the ids that occur, ascending, and indices into these.
///
/// Ascending, so that the lists of a file whose ids ascend do so too; the records of one id become
/// one.
void index_records(Analysis& analysis);

}  // namespace meshalyzer
