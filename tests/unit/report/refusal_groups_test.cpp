#include "meshalyzer/report/refusal_groups.h"

#include "sample_repair.h"

#include <gtest/gtest.h>

#include <vector>

namespace meshalyzer {
namespace {

using List = std::vector<std::int64_t>;

LoggedRefusal refusal(Index vertex, Index face, std::string reason = "too far") {
  return {.pass = "weld borders",
          .code = DefectCode::Slit,
          .vertex = vertex,
          .face = face,
          .reason = std::move(reason)};
}

/// The log must outlive the groups.
std::vector<RefusalGroup> groups_of(const RepairResult& result) {
  const RepairReport report = sample_report(result);
  return group_refusals(report, KeyIds(report));
}

TEST(GroupRefusals, NothingRefusedMakesNoGroup) {
  const RepairResult result = sample_result();
  EXPECT_TRUE(groups_of(result).empty());
}

TEST(GroupRefusals, OneReasonMakesOneGroupOfPlacesByTheIdsOfTheOutput) {
  RepairResult result = sample_result();
  result.log.refusals = {refusal(3, 2), refusal(0, 0), refusal(kNoIndex, 3)};
  const std::vector<RefusalGroup> groups = groups_of(result);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].first->reason, "too far");
  EXPECT_EQ(groups[0].mesh, 0U);
  EXPECT_EQ(groups[0].places, 3U);
  EXPECT_EQ(groups[0].vertices, (List{1, 3}));
  EXPECT_EQ(groups[0].faces, List{3});
}

TEST(GroupRefusals, PlaceThatWasLookedAtTwiceCountsOnce) {
  RepairResult result = sample_result();
  result.log.refusals = {refusal(0, 0), refusal(0, 0)};
  const std::vector<RefusalGroup> groups = groups_of(result);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].places, 1U);
  EXPECT_EQ(groups[0].vertices, List{1});
}

TEST(GroupRefusals, TwoPlacesAtOneVertexNameItOnce) {
  RepairResult result = sample_result();
  result.log.refusals = {refusal(0, 0), refusal(0, 2)};
  const std::vector<RefusalGroup> groups = groups_of(result);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].places, 2U);
  EXPECT_EQ(groups[0].vertices, List{1});
}

TEST(GroupRefusals, OtherPassCodeOrReasonMakesAnotherGroup) {
  RepairResult result = sample_result();
  LoggedRefusal other_pass = refusal(0, 0);
  other_pass.pass = "fill holes";
  LoggedRefusal other_code = refusal(0, 0);
  other_code.code = DefectCode::Hole;
  result.log.refusals = {refusal(0, 0), other_pass, other_code, refusal(0, 0, "meets others")};
  const std::vector<RefusalGroup> groups = groups_of(result);
  ASSERT_EQ(groups.size(), 4U);
  EXPECT_EQ(groups[1].first->pass, "fill holes");
  EXPECT_EQ(groups[2].first->code, DefectCode::Hole);
  EXPECT_EQ(groups[3].first->reason, "meets others");
}

TEST(GroupRefusals, WhatIsGoneBelongsToNoMesh) {
  RepairResult result = sample_result();
  result.log.refusals = {refusal(2, 1), refusal(kNoIndex, kNoIndex)};
  const std::vector<RefusalGroup> groups = groups_of(result);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].mesh, std::nullopt);
  EXPECT_EQ(groups[0].places, 2U);
  EXPECT_TRUE(groups[0].vertices.empty());
  EXPECT_TRUE(groups[0].faces.empty());
}

}  // namespace
}  // namespace meshalyzer
