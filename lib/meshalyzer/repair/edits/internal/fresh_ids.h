#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/edits/internal/skipped_operations.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// The records after edits: for each the old record that it is, or a number from n_old on for a new
/// one.
struct EditedRecords {
  std::span<const Index> sources;
  std::size_t n_old = 0;
};

/// Returns ids that no record has: those after the largest or, if these do not suffice, the
/// smallest free ones from 1 on.
///
/// @param taken  The ids of the records, in any order.
[[nodiscard]] std::vector<std::int32_t> fresh_ids(const std::vector<std::int32_t>& taken,
                                                  std::size_t n);

/// Returns the ids of the records of a file that numbers them: old ones keep theirs, new ones get
/// fresh_ids().
[[nodiscard]] Ids edit_ids(const Ids& old, const EditedRecords& records,
                           std::span<const Edits::ChangedId> changed,
                           const SkippedOperations& skipped);

}  // namespace meshalyzer
