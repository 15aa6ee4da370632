#include "meshalyzer/base/disjoint_sets.h"

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

}  // namespace
}  // namespace meshalyzer
