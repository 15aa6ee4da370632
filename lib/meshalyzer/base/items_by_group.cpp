#include "meshalyzer/base/items_by_group.h"

#include <numeric>

namespace meshalyzer {

ItemsByGroup::ItemsByGroup(std::span<const Index> group_of, std::size_t n_groups)
    : begin_(n_groups + 1, 0) {
  for (const Index group : group_of) {
    if (group != kNoIndex) ++begin_[group + 1];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  items_.resize(begin_.back());
  std::vector<Index> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < group_of.size(); ++i) {
    if (group_of[i] != kNoIndex) items_[next[group_of[i]]++] = static_cast<Index>(i);
  }
}

}  // namespace meshalyzer
