#include "meshalyzer/mesh/repeated_ids.h"

#include "meshalyzer/base/parallel_sort.h"

#include <algorithm>
#include <cstdint>
#include <functional>

namespace meshalyzer {

std::vector<Index> find_repeated_ids(const Ids& ids) {
  const std::vector<std::int32_t>& named = ids.named;
  const auto first = std::adjacent_find(named.begin(), named.end(), std::greater_equal<>());
  if (first == named.end()) return {};
  // One key holds id and record.
  std::vector<std::uint64_t> keys(named.size());
  for (std::size_t i = 0; i < named.size(); ++i) {
    keys[i] = std::uint64_t{static_cast<std::uint32_t>(named[i])} << 32U | i;
  }
  parallel_sort(keys);
  std::vector<Index> repeated;
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (keys[i] >> 32U == keys[i - 1] >> 32U) {
      repeated.push_back(static_cast<Index>(keys[i] & 0xFFFFFFFFU));
    }
  }
  std::sort(repeated.begin(), repeated.end());
  return repeated;
}

}  // namespace meshalyzer
