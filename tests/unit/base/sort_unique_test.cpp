#include "meshalyzer/base/sort_unique.h"

#include <gtest/gtest.h>

#include <vector>

namespace meshalyzer {
namespace {

TEST(SortUnique, ListBecomesAscendingWithEachElementOnce) {
  std::vector<int> list{3, 1, 3, 2, 1};
  sort_unique(list);
  EXPECT_EQ(list, (std::vector<int>{1, 2, 3}));
}

TEST(SortUnique, EmptyListStaysEmpty) {
  std::vector<int> list;
  sort_unique(list);
  EXPECT_TRUE(list.empty());
}

}  // namespace
}  // namespace meshalyzer
