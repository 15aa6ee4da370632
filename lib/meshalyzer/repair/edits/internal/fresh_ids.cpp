#include "meshalyzer/repair/edits/internal/fresh_ids.h"

#include "meshalyzer/io/references.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Returns the ids from 1 on that are not taken.
std::vector<std::int32_t> smallest_free(std::vector<std::int32_t> taken, std::size_t n) {
  std::sort(taken.begin(), taken.end());
  std::vector<std::int32_t> free;
  auto next = taken.begin();
  for (std::int32_t id = 1; free.size() < n; ++id) {
    next = std::lower_bound(next, taken.end(), id);
    if (next == taken.end() || *next != id) free.push_back(id);
  }
  return free;
}

}  // namespace

std::vector<std::int32_t> fresh_ids(const std::vector<std::int32_t>& taken, std::size_t n) {
  const std::int32_t largest =
      taken.empty() ? 0 : std::max(0, *std::max_element(taken.begin(), taken.end()));
  const auto room = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max() - largest);
  if (n > room) return smallest_free(taken, n);
  std::vector<std::int32_t> fresh(n);
  for (std::size_t i = 0; i < n; ++i) fresh[i] = largest + 1 + static_cast<std::int32_t>(i);
  return fresh;
}

Ids edit_ids(const Ids& old, const EditedRecords& records,
             std::span<const Edits::ChangedId> changed, const SkippedOperations& skipped) {
  std::vector<std::int32_t> by_record(records.n_old);
  for (std::size_t i = 0; i < records.n_old; ++i) {
    by_record[i] = static_cast<std::int32_t>(old.of(static_cast<Index>(i)));
  }
  for (const Edits::ChangedId& change : changed) {
    if (!skipped(change.op)) by_record[change.record] = change.id;
  }
  std::vector<std::int32_t> kept;
  kept.reserve(records.sources.size());
  for (const Index source : records.sources) {
    if (source < records.n_old) kept.push_back(by_record[source]);
  }
  // New ids never repeat one of a dropped record, so that the log is unambiguous.
  const auto fresh = fresh_ids(by_record, records.sources.size() - kept.size());
  std::vector<std::int32_t> ids;
  ids.reserve(records.sources.size());
  auto next_kept = kept.begin();
  auto next_fresh = fresh.begin();
  for (const Index source : records.sources) {
    ids.push_back(source < records.n_old ? *next_kept++ : *next_fresh++);
  }
  Ids result = compact_ids(std::move(ids));
  if (records.sources.empty()) result.first = old.first;
  return result;
}

}  // namespace meshalyzer
