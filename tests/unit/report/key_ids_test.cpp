#include "meshalyzer/report/key_ids.h"

#include "sample_repair.h"

#include <gtest/gtest.h>

#include <vector>

namespace meshalyzer {
namespace {

using List = std::vector<std::int64_t>;

/// What is told of a list of elements, and of each of them in the end; -1 for nothing.
template <typename Find>
List finals(const std::vector<Index>& keys, Find find) {
  List ids;
  for (const Index key : keys) {
    const auto final = find(key);
    ids.push_back(final ? final->id : -1);
  }
  return ids;
}

TEST(KeyIds, WhatWasThereHasTheIdsOfTheInput) {
  const RepairResult result = sample_result();
  const RepairReport report = sample_report(result);
  const KeyIds ids(report);
  EXPECT_EQ(ids.vertices({0, 1, 2, 3}), (List{10, 20, 30, 40}));
  EXPECT_EQ(ids.faces({2, 1, 0}), (List{7, 6, 5}));
}

TEST(KeyIds, WhatWasAddedHasTheIdsOfTheOutput) {
  const RepairResult result = sample_result();
  const RepairReport report = sample_report(result);
  const KeyIds ids(report);
  EXPECT_EQ(ids.vertices({4}), List{4});
  EXPECT_EQ(ids.faces({3}), List{3});
}

TEST(KeyIds, WhatWasAddedAndIsGoneIsLeftOut) {
  const RepairResult result = sample_result();
  const RepairReport report = sample_report(result);
  const KeyIds ids(report);
  EXPECT_EQ(ids.vertices({9, 0}), List{10});
  EXPECT_EQ(ids.faces({9}), List{});
}

TEST(KeyIds, InTheEndAllHaveTheIdsOfTheOutput) {
  const RepairResult result = sample_result();
  const RepairReport report = sample_report(result);
  const KeyIds ids(report);
  const auto vertex = [&](Index key) { return ids.final_vertex(key); };
  const auto face = [&](Index key) { return ids.final_face(key); };
  EXPECT_EQ(finals({0, 1, 2, 3, 4, 5, kNoIndex}, vertex), (List{1, 2, -1, 3, 4, -1, -1}));
  EXPECT_EQ(finals({0, 1, 2, 3, 4, kNoIndex}, face), (List{1, -1, 2, 3, -1, -1}));
}

TEST(KeyIds, FormatThatNumbersVerticesAnewIsFollowed) {
  const RepairResult result = sample_result();
  RepairReport report = sample_report(result);
  // On disk the last vertex of the tracked mesh comes first, and the second was dropped.
  report.meshes[0].vertex_records = {1, kNoIndex, 2, 0};
  const KeyIds ids(report);
  const auto vertex = [&](Index key) { return ids.final_vertex(key); };
  EXPECT_EQ(finals({0, 1, 3, 4}, vertex), (List{2, -1, 3, 1}));
  EXPECT_EQ(ids.vertices({4}), List{1});
}

TEST(KeyIds, OfSeveralMeshesTheRightOneIsNamed) {
  RepairResult result = sample_result();
  TrackedMesh& first = result.meshes[0].tracked;
  TrackedMesh second = first;
  first.vertex_keys = {0, 1};
  first.face_keys = {0};
  second.vertex_keys = {3, 4};
  second.face_keys = {2, 3};
  result.meshes.push_back({second, {}, nullptr});
  RepairReport report = sample_report(result);
  report.meshes.push_back(report.meshes[0]);
  const KeyIds ids(report);
  ASSERT_TRUE(ids.final_face(0) && ids.final_face(3) && ids.final_vertex(3));
  EXPECT_EQ(ids.final_face(0)->mesh, 0U);
  EXPECT_EQ(ids.final_face(3)->mesh, 1U);
  EXPECT_EQ(ids.final_face(3)->id, 2);
  EXPECT_EQ(ids.final_vertex(3)->mesh, 1U);
}

}  // namespace
}  // namespace meshalyzer
