#include "meshalyzer/base/parallel.h"
#include "random_damage.h"
#include "repair_laws.h"
#include "soups_to_try.h"
#include "support/effort.h"
#include "support/same_soup.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::uint32_t kDamagedSoups = 200;
/// Of the next forty thousand, those that have broken a law: what comes of a patch, or of a border
/// that is one no more, needs care.
constexpr std::array<std::uint32_t, 15> kHardSeeds{2596,  2597,  2831,  2949,  5227,
                                                   7426,  15652, 16835, 21160, 21944,
                                                   29302, 29772, 35262, 37000, 39377};

std::vector<std::uint32_t> seeds_to_try() {
  std::vector<std::uint32_t> seeds(kDamagedSoups);
  std::iota(seeds.begin(), seeds.end(), 0U);
  seeds.insert(seeds.end(), kHardSeeds.begin(), kHardSeeds.end());
  return seeds;
}

/// The options that a seed stands for, so that all are tried on all kinds of damage.
RepairOptions options_for(std::uint32_t seed) {
  RepairOptions options;
  if (seed % 5 == 1) options.borders = Borders::Intended;
  if (seed % 5 == 2) options.groups = Groups::Faces;
  if (seed % 5 == 3) options.contact = Contact::Keep;
  if (seed % 5 == 4) options.fill.sheets = FillSheets::Yes;
  if (seed % 7 == 3) options.fixes.insert(DefectCode::Numbering);
  if (seed % 7 == 4) options.fill.shape = FillShape::Smooth;
  if (seed % 11 == 5) options.max_deviation.value = 0.0;
  if (seed % 11 == 6) options.max_deviation.value = 0.05;
  return options;
}

using Law = std::function<void(const Soup&, const RepairResult&, const RepairOptions&)>;

/// Repairs damaged meshes one after the other.
void for_damaged_meshes(const Law& law) {
  test::Effort effort;
  for (const std::uint32_t seed : seeds_to_try()) {
    if (!effort.runs_next()) continue;
    const NamedSoup mesh = damaged_mesh(seed);
    SCOPED_TRACE(mesh.name);
    const RepairOptions options = options_for(seed);
    law(mesh.soup, fix_defects(mesh.soup, options), options);
  }
}

TEST(RepairLaw, ResultHoldsTogether) {
  for_damaged_meshes(
      [](const Soup&, const RepairResult& result, const RepairOptions&) { expect_valid(result); });
}

TEST(RepairLaw, NothingIsWorseThanBefore) {
  for_damaged_meshes(expect_never_worse);
}

TEST(RepairLaw, RepairingAgainChangesNothing) {
  for_damaged_meshes([](const Soup&, const RepairResult& result, const RepairOptions& options) {
    expect_done(result, options);
  });
}

TEST(RepairLaw, WhatRemainsHasAReason) {
  for_damaged_meshes([](const Soup&, const RepairResult& result, const RepairOptions& options) {
    expect_reasons(result, options);
  });
}

TEST(RepairLaw, NothingComesOrGoesWithoutALineInTheLog) {
  for_damaged_meshes([](const Soup& input, const RepairResult& result, const RepairOptions&) {
    expect_log_complete(input, result);
  });
}

TEST(RepairLaw, WhatTheLogDoesNotNameStaysBitForBit) {
  for_damaged_meshes([](const Soup& input, const RepairResult& result, const RepairOptions&) {
    expect_rest_untouched(input, result);
  });
}

TEST(RepairLaw, NoSampleOfEitherSurfaceIsFartherThanTheBound) {
  for_damaged_meshes([](const Soup& input, const RepairResult& result, const RepairOptions&) {
    expect_within_deviation(input, result);
  });
}

TEST(RepairLaw, NoFacesIntersectThatDidNotBefore) {
  for_damaged_meshes([](const Soup&, const RepairResult& result, const RepairOptions& options) {
    if (options.contact == Contact::Keep) return;
    if (result.before.count(DefectCode::SelfIntersection) != 0) return;
    for (const LoggedRefusal& refusal : result.log.refusals) {
      // Copies that could not be parted touch.
      if (refusal.pass == "part contacts") return;
    }
    EXPECT_EQ(result.meshes.front().remaining.count(DefectCode::SelfIntersection), 0U);
  });
}

/// Tells whether a step was refused as too far from the input: from the output it may not be.
bool is_at_the_bound(const RepairResult& result) {
  return std::any_of(
      result.log.refusals.begin(), result.log.refusals.end(),
      [](const LoggedRefusal& refusal) { return refusal.rejection == Rejection::TooFar; });
}

TEST(RepairLaw, WildMeshesComeOutValidAndLoggedAndDone) {
  test::Effort effort;
  for (const NamedSoup& mesh : soups_to_try()) {
    if (!effort.runs_next()) continue;
    SCOPED_TRACE(mesh.name);
    const RepairResult result = fix_defects(mesh.soup);
    expect_valid(result);
    expect_log_complete(mesh.soup, result);
    expect_rest_untouched(mesh.soup, result);
    if (!is_at_the_bound(result)) expect_done(result, {});
  }
}

TEST(RepairLaw, GoodMeshesComeOutBitForBit) {
  for (const NamedSoup& mesh : good_meshes()) {
    for (const double scale : {1.0, 1e-6, 1e6}) {
      SCOPED_TRACE(mesh.name);
      const Soup soup = shapes::scaled(mesh.soup, scale);
      const RepairResult result = fix_defects(soup);
      EXPECT_TRUE(same_soup(result.meshes.front().tracked.soup, soup));
      EXPECT_TRUE(result.log.steps.empty());
      EXPECT_TRUE(result.log.operations.empty());
      EXPECT_TRUE(result.log.refusals.empty());
      EXPECT_EQ(result.deviation, 0.0);
    }
  }
}

/// All that a log says, but for lengths.
std::string described(const RepairLog& log) {
  std::string text;
  const auto add = [&](const std::vector<Index>& keys) {
    for (const Index key : keys) text.append(" ").append(std::to_string(key));
    text += ';';
  };
  for (const LoggedOperation& operation : log.operations) {
    text += log.steps[operation.step].pass;
    add(operation.removed_faces);
    add(operation.added_faces);
    add(operation.changed_faces);
    add(operation.removed_vertices);
    add(operation.added_vertices);
    add(operation.moved_vertices);
  }
  for (const LoggedRefusal& refusal : log.refusals) {
    text += refusal.pass + refusal.reason;
    add({refusal.vertex, refusal.face});
  }
  return text;
}

TEST(RepairLaw, NumberOfThreadsChangesNothing) {
  test::Effort effort;
  for (std::uint32_t seed = 0; seed < kDamagedSoups; seed += 3) {
    if (!effort.runs_next()) continue;
    const NamedSoup mesh = damaged_mesh(seed);
    SCOPED_TRACE(mesh.name);
    const RepairOptions options = options_for(seed);
    const RepairResult expected = [&] {
      const ThreadLimit one(1);
      return fix_defects(mesh.soup, options);
    }();
    for (const std::size_t n : {2U, 7U}) {
      const ThreadLimit limit(n);
      const RepairResult result = fix_defects(mesh.soup, options);
      EXPECT_TRUE(
          same_soup(result.meshes.front().tracked.soup, expected.meshes.front().tracked.soup));
      EXPECT_EQ(described(result.log), described(expected.log));
      EXPECT_EQ(result.deviation, expected.deviation);
    }
  }
}

}  // namespace
}  // namespace meshalyzer
