#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/edits/internal/skipped_operations.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// Tells which records there are after edits: of each the old one it is, or a number from n_old on
/// for a new one.
struct EditedRecords {
  std::span<const Index> sources;
  std::size_t n_old = 0;
};

/// Ids that no record has: those after the largest, or, where there are not enough, the smallest
/// from 1 on that are free.
///
/// @param taken  In any order.
[[nodiscard]] std::vector<std::int32_t> fresh_ids(const std::vector<std::int32_t>& taken,
                                                  std::size_t n);

/// Returns the ids of records that a file numbers by itself: those that stay keep theirs, new ones
/// get fresh_ids().
[[nodiscard]] Ids edit_ids(const Ids& old, const EditedRecords& records,
                           std::span<const Edits::ChangedId> changed,
                           const SkippedOperations& skipped);

}  // namespace meshalyzer
