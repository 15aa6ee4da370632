#include "meshalyzer/base/items_by_group.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

std::vector<std::vector<Index>> groups_of(const ItemsByGroup& items) {
  std::vector<std::vector<Index>> groups;
  for (std::size_t group = 0; group < items.size(); ++group) {
    groups.emplace_back(items[group].begin(), items[group].end());
  }
  return groups;
}

TEST(ItemsByGroup, ItemsOfNoGroupAreInNone) {
  const std::vector<Index> group_of{2, kNoIndex, 0, 2, kNoIndex};
  EXPECT_EQ(groups_of(ItemsByGroup(group_of, 4)),
            (std::vector<std::vector<Index>>{{2}, {}, {0, 3}, {}}));
}

TEST(ItemsByGroup, ItemsOfSeveralGroupsKeepTheirOrder) {
  const std::vector<std::pair<std::size_t, Index>> given{{1, 7}, {0, 3}, {1, 2}, {1, 7}, {2, 3}};
  const ItemsByGroup items(4, [&](const auto& use) {
    for (const auto& [group, item] : given) use(group, item);
  });
  EXPECT_EQ(groups_of(items), (std::vector<std::vector<Index>>{{3}, {7, 2, 7}, {3}, {}}));
}

TEST(ItemsByGroup, ThereMayBeNoGroups) {
  EXPECT_EQ(ItemsByGroup().size(), 0U);
  EXPECT_EQ(ItemsByGroup(std::vector<Index>{kNoIndex}, 0).size(), 0U);
}

}  // namespace
}  // namespace meshalyzer
