#include "meshalyzer/report/set_verdict.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

SetAnalysis good_set() {
  SetAnalysis set;
  set.good = 2;
  set.intersections.emplace();
  return set;
}

std::optional<bool> is_good(const SetAnalysis& set) {
  const std::optional<Goodness> verdict = set_verdict(set);
  return verdict ? std::optional(verdict->good) : std::nullopt;
}

TEST(SetIsGood, MeshesThatAreGoodAndApartAre) {
  EXPECT_EQ(is_good(good_set()), true);
}

TEST(SetIsGood, NothingIsSaidWhereMeshesWereNotJudged) {
  SetAnalysis set = good_set();
  set.good.reset();
  EXPECT_EQ(is_good(set), std::nullopt);
}

TEST(SetIsGood, OneMeshThatIsNotGoodOrUnreadableIsEnough) {
  SetAnalysis set = good_set();
  set.not_good = {{1, {"not closed"}}};
  EXPECT_EQ(is_good(set), false);
  set.not_good = {{1, {"cannot be read"}}};
  set.unreadable = 1;
  EXPECT_EQ(is_good(set), false);
}

TEST(SetIsGood, IntersectingMeshesAreNot) {
  SetAnalysis set = good_set();
  set.intersections->pairs = {{}};
  EXPECT_EQ(is_good(set), false);
}

TEST(SetIsGood, ContainedMeshesAreNot) {
  SetAnalysis set = good_set();
  set.intersections->contained = {{0, 1}};
  EXPECT_EQ(is_good(set), false);
  set = good_set();
  set.intersections->partly_contained = {{0, 1}};
  EXPECT_EQ(is_good(set), false);
}

TEST(SetIsGood, WhatWasNotAskedForDoesNotMatter) {
  SetAnalysis set = good_set();
  set.intersections.reset();
  EXPECT_EQ(is_good(set), true);
}

TEST(SetVerdict, ReasonsAreCounted) {
  SetAnalysis set = good_set();
  set.not_good = {{1, {"cannot be read"}}, {2, {"not closed"}}, {3, {"cannot be read"}}};
  set.unreadable = 2;
  set.intersections->pairs = {{}, {}};
  set.intersections->contained = {{0, 1}};
  ASSERT_TRUE(set_verdict(set));
  EXPECT_EQ(set_verdict(set)->reasons,
            (std::vector<std::string>{"1 mesh is not good", "2 files cannot be read",
                                      "2 pairs of faces of different meshes intersect",
                                      "1 mesh is inside another one"}));
}

TEST(SetVerdict, SearchThatWasStoppedHasFoundAtLeastSoMuch) {
  SetAnalysis set = good_set();
  set.intersections->contained = {{0, 1}};
  set.intersections->partly_contained = {{2, 1}, {3, 1}};
  set.intersections->is_search_stopped = true;
  ASSERT_TRUE(set_verdict(set));
  EXPECT_EQ(set_verdict(set)->reasons,
            (std::vector<std::string>{"at least 0 pairs of faces of different meshes intersect, "
                                      "the search ended at its time limit",
                                      "at least 1 mesh is inside another one",
                                      "at least 2 meshes are partly inside another one"}));
}

}  // namespace
}  // namespace meshalyzer
