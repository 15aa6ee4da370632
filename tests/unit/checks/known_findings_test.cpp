#include "meshalyzer/checks/known_findings.h"

#include "meshalyzer/checks/check_mesh.h"
#include "meshalyzer/checks/profile.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

FileFindings all_of(const Soup& soup) {
  CheckCriteria criteria = find_profile("solid")->criteria;
  criteria.max_listed = 0;
  return check_mesh(soup, "it", criteria);
}

/// A cube with two unused vertices.
Soup with_orphans(double x, double y) {
  Soup soup = shapes::cube();
  soup.positions.emplace_back(x, 5.0, 5.0);
  soup.positions.emplace_back(y, 5.0, 5.0);
  return soup;
}

TEST(KnownFindings, SameFindingsAreAllKnownWhateverTheirNumbers) {
  FileFindings file = all_of(with_orphans(7, 6));
  KnownFindings(known_of(all_of(with_orphans(6, 7)))).drop_from(file);
  EXPECT_TRUE(file.is_good());
  EXPECT_TRUE(file.findings.empty());
}

TEST(KnownFindings, FindingInAnotherPlaceIsNew) {
  FileFindings file = all_of(with_orphans(6, 8));
  KnownFindings(known_of(all_of(with_orphans(6, 7)))).drop_from(file);
  ASSERT_EQ(file.counts.size(), 1U);
  EXPECT_EQ(file.counts[0].count, 1U);
  EXPECT_EQ(file.counts[0].fixable, 1U);
  ASSERT_EQ(file.findings.size(), 1U);
  EXPECT_EQ(file.findings[0].position, Vec3(8, 5, 5));
}

TEST(KnownFindings, EachAcceptsOneFinding) {
  FileFindings file = all_of(with_orphans(6, 6));
  KnownFindings(known_of(all_of(with_orphans(6, 7)))).drop_from(file);
  EXPECT_EQ(file.findings.size(), 1U);
}

TEST(KnownFindings, FileOfAnotherNameIsNotKnown) {
  FileFindings file = all_of(with_orphans(6, 7));
  KnownFindings known(known_of(file));
  file.path = "that";
  known.drop_from(file);
  EXPECT_EQ(file.findings.size(), 2U);
}

TEST(CutListed, CountsStay) {
  FileFindings file = all_of(with_orphans(6, 7));
  cut_listed(file, 1);
  EXPECT_EQ(file.findings.size(), 1U);
  EXPECT_EQ(file.counts[0].count, 2U);
  cut_listed(file, 0);
  EXPECT_EQ(file.findings.size(), 1U);
}

/// Findings of four codes, ten of each.
FileFindings many_of_four_codes() {
  FileFindings file;
  for (const std::string_view code : {"hole", "slit", "flipped", "numbering"}) {
    file.counts.push_back({.code = code, .count = 10});
    for (int i = 0; i < 10; ++i) file.findings.emplace_back().code = code;
  }
  return file;
}

TEST(CutListed, FewerOfEachCodeAreLeftWhereThereWouldBeTooManyLines) {
  FileFindings file = many_of_four_codes();
  cut_listed(file, 5, 24);  // five of each code and a line for the rest: 24 lines
  EXPECT_EQ(file.findings.size(), 20U);
  cut_listed(file, 5, 23);
  EXPECT_EQ(file.findings.size(), 16U);
  cut_listed(file, 5, 4);  // not even one
  EXPECT_TRUE(file.findings.empty());
  EXPECT_EQ(file.counts.size(), 4U);
}

}  // namespace
}  // namespace meshalyzer
