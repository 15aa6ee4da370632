#include "meshalyzer/set/shard.h"

#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

std::vector<ShardRange> ranges(std::size_t count, const std::vector<Index>& order,
                               const std::vector<std::size_t>& n_faces) {
  std::vector<ShardRange> all;
  for (std::size_t number = 0; number < count; ++number) {
    all.push_back(range_of({.number = number, .count = count}, order, n_faces));
  }
  return all;
}

/// Each range begins where the one before ends, and all together are everything.
void expect_partition(const std::vector<ShardRange>& all, std::size_t n) {
  std::size_t end = 0;
  for (const ShardRange& range : all) {
    EXPECT_EQ(range.begin, end);
    EXPECT_LE(range.begin, range.end);
    end = range.end;
  }
  EXPECT_EQ(end, n);
}

TEST(RangeOf, OneShardHasEverything) {
  expect_partition(ranges(1, {2, 0, 1}, {5, 1, 9}), 3);
}

TEST(RangeOf, NoObjectsLeaveNothingToShare) {
  expect_partition(ranges(3, {}, {}), 0);
  expect_partition(ranges(3, {}, {4, 4}), 0);
}

TEST(RangeOf, ObjectsOfOneSizeAreSharedOutEvenly) {
  const std::vector<Index> order = shapes::permutation(12, 1);
  for (const ShardRange& range : ranges(4, order, std::vector<std::size_t>(12, 100))) {
    EXPECT_EQ(range.end - range.begin, 3U);
  }
}

TEST(RangeOf, RangesShareOutTheFacesWhateverTheSizes) {
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    const std::size_t n = 1 + below(random, 40);
    // The last ones have no face and are in no order.
    const std::size_t n_ordered = n - below(random, static_cast<Index>(n));
    std::vector<std::size_t> n_faces(n, 0);
    for (std::size_t i = 0; i < n_ordered; ++i) {
      n_faces[i] = 1 + below(random, below(random, 4) == 0 ? 100000 : 50);
    }
    const std::vector<Index> order = shapes::permutation(n_ordered, below(random, 1000));
    const std::size_t count = 1 + below(random, 60);
    const std::vector<ShardRange> all = ranges(count, order, n_faces);
    expect_partition(all, n_ordered);
    // A range holds the objects whose middle is in its share of all faces, so at most the halves of
    // two objects are too many or too few.
    const double total = std::accumulate(n_faces.begin(), n_faces.end(), 0.0);
    const auto largest = static_cast<double>(*std::max_element(n_faces.begin(), n_faces.end()));
    for (const ShardRange& range : all) {
      double mine = 0;
      for (std::size_t i = range.begin; i < range.end; ++i) {
        mine += static_cast<double>(n_faces[order[i]]);
      }
      EXPECT_LE(std::abs(mine - total / static_cast<double>(count)), largest + 1);
    }
  }
}

TEST(RangeOf, MoreShardsThanObjectsLeaveSomeWithoutWork) {
  const std::vector<ShardRange> all = ranges(50, {1, 0, 2}, {7, 9, 8});
  expect_partition(all, 3);
  for (const ShardRange& range : all) {
    EXPECT_LE(range.end - range.begin, 1U);
  }
}

TEST(RangeOf, ObjectsWithoutFacesAreSharedOutToo) {
  expect_partition(ranges(3, {0, 1, 2, 3}, {0, 5, 0, 0}), 4);
  expect_partition(ranges(3, {1, 0}, {0, 0}), 2);
}

TEST(OwnsFile, EachFileIsOneShardsAndNeighboursAreOfDifferentOnes) {
  for (std::size_t file = 0; file < 30; ++file) {
    std::size_t n_owners = 0;
    for (std::size_t number = 0; number < 7; ++number) {
      const Shard shard{.number = number, .count = 7};
      n_owners += shard.owns_file(file) ? 1 : 0;
      EXPECT_FALSE(shard.owns_file(file) && shard.owns_file(file + 1));
    }
    EXPECT_EQ(n_owners, 1U);
  }
}

TEST(OwnsFile, WithoutShardsAllFilesAreOwned) {
  EXPECT_TRUE(Shard().owns_file(0));
  EXPECT_TRUE(Shard().owns_file(5));
}

}  // namespace
}  // namespace meshalyzer
