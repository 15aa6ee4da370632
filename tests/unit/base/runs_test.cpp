#include "meshalyzer/base/runs.h"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Returns the second parts of the items of each run of items with the same first part.
std::vector<std::string> runs_of(const std::vector<std::pair<int, char>>& items) {
  std::vector<std::string> runs;
  for_each_run(std::span(items), &std::pair<int, char>::first, [&](const auto& run) {
    runs.emplace_back();
    for (const auto& [key, letter] : run) runs.back().push_back(letter);
  });
  return runs;
}

TEST(ForEachRun, SuccessiveItemsWithTheSameKeyComeTogether) {
  EXPECT_EQ(runs_of({{1, 'a'}, {1, 'b'}, {2, 'c'}, {1, 'd'}, {1, 'e'}}),
            (std::vector<std::string>{"ab", "c", "de"}));
}

TEST(ForEachRun, NoItemsHaveNoRun) {
  EXPECT_TRUE(runs_of({}).empty());
}

}  // namespace
}  // namespace meshalyzer
