#include "meshalyzer/base/disjoint_sets.h"

#include "meshalyzer/base/parallel.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

TEST(DisjointSets, EachNumberIsASetOfItsOwnAtFirst) {
  DisjointSets sets(3);
  for (Index i = 0; i < 3; ++i) EXPECT_EQ(sets.find(i), i);
}

TEST(DisjointSets, UnitedSetsAreNamedByTheirLowestElement) {
  DisjointSets sets(5);
  sets.unite(4, 3);
  sets.unite(2, 1);
  sets.unite(4, 2);
  for (Index i = 1; i < 5; ++i) EXPECT_EQ(sets.find(i), 1U);
  EXPECT_EQ(sets.find(0), 0U);
}

TEST(DisjointSets, NumberUnitedWithItselfStaysAlone) {
  DisjointSets sets(2);
  sets.unite(1, 1);
  EXPECT_EQ(sets.find(1), 1U);
}

TEST(DisjointSets, ThreadsThatUniteAtATimeMakeTheSetsThatOneWouldMake) {
  // Each thread joins every number with the one 10 places on, in an order of its own.
  constexpr Index n = 50000;
  const ThreadLimit limit(4);
  DisjointSets sets(n);
  parallel_chunks(8, 1, [&](Chunk chunk) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto a = static_cast<Index>(i * (2 * chunk.number + 7) % n);
      if (a + 10 < n) sets.unite(a, a + 10);
    }
  });
  for (Index i = 0; i < n; ++i) ASSERT_EQ(sets.find(i), i % 10);
}

}  // namespace
}  // namespace meshalyzer
