#include "meshalyzer/report/text/summary_table.h"

#include "meshalyzer/report/text/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::size_t kWidth = 10;

/// The line but for its last column.
std::string without_reason(const std::string& line) {
  constexpr std::size_t kColumns = kWidth + 79;
  return line.substr(0, kColumns);
}

Analysis good_cube() {
  Analysis analysis;
  analysis.attributes = {.closed = {true, ""},
                         .manifold = {true, ""},
                         .orientable = {true, ""},
                         .consistent = {true, ""},
                         .outward = {true, ""}};
  analysis.characteristics.faces = 12;
  analysis.characteristics.components = 1;
  analysis.characteristics.genus.value = 0;
  analysis.characteristics.area = 6;
  analysis.characteristics.volume.value = 1;
  analysis.fitness = Goodness{true, {}};
  return analysis;
}

TEST(SummaryLine, StandsUnderTheTitles) {
  EXPECT_EQ(summary_header(kWidth),
            "mesh          faces closed manifold outward comps genus selfint      area     volume "
            "good  reason\n");
  EXPECT_EQ(summary_line("cube.mesh", good_cube(), kWidth),
            "cube.mesh        12    yes      yes     yes     1     0       0         6          1 "
            " yes\n");
}

TEST(SummaryLine, UndefinedIsADash) {
  Analysis analysis = good_cube();
  analysis.attributes.outward.value.reset();
  analysis.characteristics.genus.value.reset();
  analysis.characteristics.volume.value.reset();
  analysis.fitness.reset();
  EXPECT_EQ(summary_line("open.mesh", analysis, kWidth),
            "open.mesh        12    yes      yes       -     1     -       0         6          - "
            "   -\n");
}

TEST(SummaryLine, WhatOnlyAttributesLeaveOutIsADash) {
  Analysis analysis = good_cube();
  analysis.has_characteristics = false;
  analysis.fitness.reset();
  EXPECT_EQ(summary_line("cube.mesh", analysis, kWidth),
            "cube.mesh        12    yes      yes     yes     1     0       -         -          1 "
            "   -\n");
}

TEST(SummaryLine, MeshThatIsNotGoodTellsTheFirstReason) {
  Analysis analysis = good_cube();
  analysis.fitness = Goodness{false, {"not closed", "2 orphan vertices"}};
  EXPECT_THAT(summary_line("a", analysis, kWidth), testing::EndsWith("   no  not closed\n"));
}

TEST(SummaryLine, VerdictByThresholdsCountsBeforeTheOther) {
  Analysis analysis = good_cube();
  analysis.goodness = Goodness{false, {"aspect ratio 9"}};
  EXPECT_THAT(summary_line("a", analysis, kWidth), testing::EndsWith("   no  aspect ratio 9\n"));
}

TEST(SummaryLine, LargeNumbersKeepTheirColumns) {
  Analysis analysis = good_cube();
  analysis.characteristics.faces = 1234567890123;
  analysis.characteristics.components = 1234567;
  analysis.characteristics.intersecting_pairs = 123456789;
  analysis.characteristics.area = 1.23456e+300;
  analysis.characteristics.volume.value = -1.23456e-300;
  EXPECT_EQ(summary_line("big.mesh", analysis, kWidth),
            "big.mesh   1.23e+12    yes      yes     yes 1e+06     0 1.2e+08 1.23e+300 -1.23e-300 "
            " yes\n");
}

TEST(SummaryLine, StoppedSearchHasFoundAtLeastSoManyPairs) {
  Analysis analysis = good_cube();
  analysis.characteristics.is_search_stopped = true;
  const auto pairs_cell = [&](std::size_t n_pairs) {
    analysis.characteristics.intersecting_pairs = n_pairs;
    return summary_line("a", analysis, kWidth).substr(kWidth + 45, 8);
  };
  EXPECT_EQ(pairs_cell(0), "     >=0");
  EXPECT_EQ(pairs_cell(98765), " >=98765");
  EXPECT_EQ(pairs_cell(7837085), " >=7e+06");
}

TEST(SummaryLine, LongNamesLoseTheirMiddle) {
  // Three of the seven characters beside the gap are of the front.
  EXPECT_THAT(summary_line("abcdefghijk", {}, kWidth), testing::StartsWith("abc...hijk "));
  EXPECT_THAT(summary_line("abcdefghij", {}, kWidth), testing::StartsWith("abcdefghij "));
}

TEST(SummaryLine, NamesAreCutBetweenCharacters) {
  const std::string umlaut = "\xC3\xA4";
  std::string name;
  for (int i = 0; i < 12; ++i) {
    name += umlaut;
  }
  EXPECT_THAT(summary_line(name, {}, kWidth),
              testing::StartsWith(umlaut + umlaut + umlaut + "..." + umlaut + umlaut + umlaut +
                                  umlaut + " "));
}

TEST(SummaryLine, ControlCharactersDoNotBreakTheLine) {
  EXPECT_THAT(summary_line("a\nb\x1B[2J", {}, kWidth), testing::StartsWith("a?b?[2J    "));
}

TEST(SummaryLine, UnreadableFileKeepsTheColumnsAndTellsWhy) {
  const std::string line = summary_of_unreadable("torn.mesh", "torn.mesh:3: no number", kWidth);
  EXPECT_EQ(line,
            "torn.mesh         -      -        -       -     -     -       -         -          - "
            "  no  cannot be read: torn.mesh:3: no number\n");
  EXPECT_EQ(without_reason(line).size(), without_reason(summary_header(kWidth)).size());
}

TEST(SummaryWidth, IsThatOfTheLongestNameWithinLimits) {
  EXPECT_EQ(summary_width(std::vector<std::string>{"a"}, NameLength::Fitted), 8U);
  EXPECT_EQ(summary_width(std::vector<std::string>{"a", "twelve.mesh_"}, NameLength::Fitted), 12U);
  const std::vector<std::string> long_name{std::string(300, 'x')};
  EXPECT_EQ(summary_width(long_name, NameLength::Fitted), 40U);
  EXPECT_EQ(summary_width(long_name, NameLength::Whole), 300U);
  EXPECT_EQ(summary_width({}, NameLength::Whole), 8U);
}

}  // namespace
}  // namespace meshalyzer
