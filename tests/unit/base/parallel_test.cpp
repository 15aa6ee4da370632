#include "meshalyzer/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::size_t kSeveralChunks = 5 * kChunkLength + 7;

TEST(ParallelFilter, NumbersThatMeetTheConditionAreAscending) {
  const ThreadLimit limit(4);
  const std::vector<Index> found =
      parallel_filter(kSeveralChunks, [](Index i) { return i % 3 == 0; });
  std::vector<Index> expected;
  for (Index i = 0; i < kSeveralChunks; i += 3) expected.push_back(i);
  EXPECT_EQ(found, expected);
}

TEST(ParallelFilter, NothingHasNoNumbers) {
  EXPECT_TRUE(parallel_filter(0, [](Index) { return true; }).empty());
}

TEST(CollectChunks, ListsFollowEachOtherInOrderOfTheirChunks) {
  const ThreadLimit limit(4);
  const auto numbers =
      collect_chunks<std::size_t>(kSeveralChunks, [](Chunk chunk, std::vector<std::size_t>& items) {
        if (chunk.number % 2 == 0) items.insert(items.end(), chunk.number + 1, chunk.number);
      });
  EXPECT_EQ(numbers, (std::vector<std::size_t>{0, 2, 2, 2, 4, 4, 4, 4, 4}));
}

TEST(ParallelInvoke, AllFunctionsAreRunWhetherOrNotThereAreManyItems) {
  for (const std::size_t n_items : {std::size_t{1}, kSeveralChunks}) {
    std::atomic<int> sum = 0;
    parallel_invoke(n_items, {[&] { sum += 1; }, [&] { sum += 10; }, [&] { sum += 100; }});
    EXPECT_EQ(sum, 111);
  }
}

TEST(ThreadLimit, TheLowestOfSeveralCounts) {
  const ThreadLimit two(2);
  EXPECT_LE(max_threads(), 2U);
  {
    const ThreadLimit one(1);
    EXPECT_EQ(max_threads(), 1U);
    const ThreadLimit four(4);
    EXPECT_EQ(max_threads(), 1U);
  }
  EXPECT_EQ(max_threads(), 2U);
}

TEST(ThreadLimit, OneThreadIsThatOfTheCaller) {
  const ThreadLimit one(1);
  const std::thread::id caller = std::this_thread::get_id();
  parallel_chunks(kSeveralChunks, [&](Chunk) { EXPECT_EQ(std::this_thread::get_id(), caller); });
}

}  // namespace
}  // namespace meshalyzer
