#include "meshalyzer/report/text/offenders.h"

#include "sample_analysis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

std::string offenders_of(const Analysis& analysis, OffenderStyle style) {
  TextLines lines;
  append_offenders(lines, analysis, style);
  return lines.text();
}

TEST(AppendOffenders, ElementsAreNamedByFileIdAndEdgesWithAllFaces) {
  EXPECT_EQ(offenders_of(sample_analysis(), OffenderStyle::Ids),
            "OFFENDING ELEMENTS\n"
            "offending orphan vertices: 2\n"
            "orphan vertex 30\n"
            "orphan vertex 40\n"
            "offending missing vertices: 1\n"
            "missing vertex 99\n"
            "offending degenerate faces: 1\n"
            "degenerate face 9\n"
            "offending vertex numbering: [10] 20 30\n"
            "offending border edges: 2\n"
            "border edge 10 30: face 7\n"
            "border edge 20 30: face 7\n"
            "offending non-manifold edges: 1\n"
            "non-manifold edge 10 20: faces 7 9\n"
            "offending non-manifold vertices: 1\n"
            "non-manifold vertex 40\n"
            "offending intersecting pairs: 1\n"
            "intersecting faces 7 9: crossing\n");
}

TEST(AppendOffenders, CustomPointsAreTheVerticesOfEachElement) {
  Analysis analysis = sample_analysis();
  analysis.offenders = {};
  analysis.offenders.non_manifold_vertices = {3};
  analysis.offenders.border_edges = {{{0, 2}}, {0, 1}, {0}, {}};
  analysis.offenders.intersecting_pairs = {{0, 1, ContactKind::Crossing}};
  EXPECT_EQ(offenders_of(analysis, OffenderStyle::CustomPoints),
            "OFFENDING ELEMENTS\n"
            "offending border edges: 1\n"
            "0.1 0 0 1 0 0 1\n"
            "0 1 0 1 0 0 1\n"
            "offending non-manifold vertices: 1\n"
            "0 0 1 1 0 0 1\n"
            "offending intersecting pairs: 1\n"
            "0.1 0 0 1 0 0 1\n"
            "1 0 0 1 0 0 1\n"
            "0 1 0 1 0 0 1\n"
            "1 0 0 1 0 0 1\n"
            "0.1 0 0 1 0 0 1\n"
            "0 0 1 1 0 0 1\n");
}

TEST(AppendOffenders, CornerWithoutVertexHasNoPoint) {
  Analysis analysis = sample_analysis();
  analysis.offenders = {};
  Soup soup = *analysis.soup;
  soup.triangles[1] = {1, kNoIndex, 3};
  analysis.soup = std::make_shared<const Soup>(std::move(soup));
  analysis.offenders.faces_with_missing_vertices = {1};
  EXPECT_EQ(offenders_of(analysis, OffenderStyle::CustomPoints),
            "OFFENDING ELEMENTS\n"
            "offending faces with missing vertices: 1\n"
            "1 0 0 1 0 0 1\n"
            "0 0 1 1 0 0 1\n");
}

TEST(AppendOffenders, ListsAskedForByThresholdNeedNoOtherReason) {
  Analysis analysis = sample_analysis();
  analysis.offenders.short_edges = EdgeList{{{0, 1}}, {0, 2}, {0, 1}, {0.25}};
  analysis.offenders.large_angles = EdgeList{};
  analysis.offenders.large_aspect_ratios = FaceList{{1}, {17.5}};
  EXPECT_EQ(offenders_of(analysis, OffenderStyle::None),
            "OFFENDING ELEMENTS\n"
            "short edges: 1\n"
            "short edge 10 20: length 0.25, faces 7 9\n"
            "large edge angles: 0\n"
            "large aspect ratios: 1\n"
            "large aspect ratio of face 9: 17.5\n");
}

TEST(AppendOffenders, NothingAskedForIsNoSection) {
  EXPECT_EQ(offenders_of(sample_analysis(), OffenderStyle::None), "");
}

TEST(AppendOffenders, NothingOffendingIsSaid) {
  EXPECT_EQ(offenders_of({}, OffenderStyle::Ids), "OFFENDING ELEMENTS\noffending elements: none\n");
}

TEST(AppendOffenders, AttributesOnlyNamesWhatPreventsThem) {
  Analysis analysis = sample_analysis();
  analysis.has_characteristics = false;
  const std::string named = offenders_of(analysis, OffenderStyle::Ids);
  EXPECT_THAT(named, testing::HasSubstr("border edge 10 30: face 7\n"));
  EXPECT_THAT(named, testing::Not(testing::HasSubstr("orphan")));
  EXPECT_THAT(named, testing::Not(testing::HasSubstr("intersecting")));
}

}  // namespace
}  // namespace meshalyzer
