#include "meshalyzer/base/items_by_group.h"

namespace meshalyzer {

ItemsByGroup::ItemsByGroup(std::span<const Index> group_of, std::size_t n_groups)
    : ItemsByGroup(n_groups, [&](const auto& use) {
        for (std::size_t i = 0; i < group_of.size(); ++i) {
          if (group_of[i] != kNoIndex) use(group_of[i], static_cast<Index>(i));
        }
      }) {}

}  // namespace meshalyzer
