#include "meshalyzer/defects/check.h"

#include "meshalyzer/base/error.h"
#include "support/constants.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

namespace meshalyzer {
namespace {

/// Two squares side by side that were never welded.
Soup unwelded() {
  return shapes::merged(shapes::grid(1, 1), shapes::translated(shapes::grid(1, 1), {1, 0, 0}));
}

/// The border of grid(2, 1), as its four sides.
std::vector<Polyline> border_of_two_squares() {
  return {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
          {{2, 0, 0}, {2, 1, 0}},
          {{0, 1, 0}, {1, 1, 0}, {2, 1, 0}},
          {{0, 0, 0}, {0, 1, 0}}};
}

TEST(Check, GoodMeshIsValidAtAllLevels) {
  for (const CheckLevel level : {CheckLevel::None, CheckLevel::Basic, CheckLevel::Full}) {
    EXPECT_TRUE(check(shapes::cube(), {.level = level}).is_valid());
    EXPECT_TRUE(check(Soup{}, {.level = level}).is_valid());
  }
}

TEST(Check, BordersAndOrphansAreNotInvalid) {
  Soup soup = shapes::open_cube();
  soup.positions.emplace_back(5, 5, 5);
  EXPECT_TRUE(check(soup).is_valid());
}

TEST(Check, DataThatMakeNoMeshAreInvalidFromBasicOn) {
  Soup not_finite = shapes::cube();
  not_finite.positions[3].y() = std::numeric_limits<double>::quiet_NaN();
  Soup missing = shapes::cube();
  missing.triangles[5][2] = kNoIndex;
  missing.missing = {{5, 2, 99}};
  for (const Soup& soup : {not_finite, missing}) {
    EXPECT_TRUE(check(soup, {.level = CheckLevel::None}).is_valid());
    for (const CheckLevel level : {CheckLevel::Basic, CheckLevel::Full}) {
      const CheckResult result = check(soup, {.level = level});
      EXPECT_FALSE(result.is_valid());
      EXPECT_EQ(result.report.count(DefectCode::Corrupt), 1U);
    }
  }
}

TEST(Check, DegenerateFacetIsInvalidFromBasicOn) {
  Soup soup = shapes::cube();
  soup.positions.emplace_back(soup.positions[0]);
  soup.triangles.push_back({0, 1, 8});
  EXPECT_TRUE(check(soup, {.level = CheckLevel::None}).is_valid());
  const CheckResult basic = check(soup, {.level = CheckLevel::Basic});
  EXPECT_FALSE(basic.is_valid());
  EXPECT_EQ(basic.report.count(DefectCode::DegenerateFacet), 1U);
}

TEST(Check, NonManifoldEdgeIsInvalidFromBasicOn) {
  const CheckResult basic =
      check(shapes::two_tetrahedra_sharing_edge(), {.level = CheckLevel::Basic});
  EXPECT_GT(basic.report.count(DefectCode::NonManifold), 0U);
}

TEST(Check, SlitsAndIntersectionsAreInvalidOnlyInFull) {
  EXPECT_TRUE(check(unwelded(), {.level = CheckLevel::Basic}).is_valid());
  const CheckResult full = check(unwelded(), {.level = CheckLevel::Full});
  EXPECT_EQ(full.report.count(DefectCode::Slit), 1U);
  EXPECT_EQ(full.report.count(DefectCode::SelfIntersection), 1U);
  EXPECT_EQ(full.report.count(DefectCode::Hole), 0U);
}

TEST(Check, SeveralComponentsAreInvalidOnlyForASingleFace) {
  const Soup soup =
      shapes::merged(shapes::grid(1, 1), shapes::translated(shapes::grid(1, 1), {5, 0, 0}));
  EXPECT_TRUE(check(soup).is_valid());
  EXPECT_FALSE(check(soup, {.is_single_face = true}).is_valid());
}

TEST(Check, BorderThatMatchesItsPolylinesIsValid) {
  const std::vector<Polyline> lines = border_of_two_squares();
  EXPECT_TRUE(check(shapes::grid(2, 1), {.is_single_face = true, .polylines = lines}).is_valid());
}

TEST(Check, PolylinesCountOnlyForASingleFace) {
  const std::vector<Polyline> lines = border_of_two_squares();
  EXPECT_TRUE(check(shapes::grid(3, 3), {.polylines = lines}).is_valid());
}

TEST(Check, SegmentWithoutBorderEdgeAndEdgeWithoutSegmentAreNamed) {
  std::vector<Polyline> lines = border_of_two_squares();
  // One segment where the mesh has two edges.
  lines[0] = {{0, 0, 0}, {2, 0, 0}};
  const CheckResult result =
      check(shapes::grid(2, 1), {.is_single_face = true, .polylines = lines});
  EXPECT_FALSE(result.is_valid());
  EXPECT_EQ(result.unmatched_segments,
            (std::vector<std::array<Vec3, 2>>{{Vec3(0, 0, 0), Vec3(2, 0, 0)}}));
  EXPECT_EQ(result.unmatched_border_edges, (std::vector<std::array<Index, 2>>{{0, 1}, {1, 2}}));
  EXPECT_EQ(result.report.total(), 0U);
}

TEST(Check, PolylinesAreMatchedWithinTheSlitTolerance) {
  std::vector<Polyline> lines = border_of_two_squares();
  for (Polyline& line : lines) {
    for (Vec3& p : line) p[2] += 0.01;
  }
  CheckOptions options{.is_single_face = true, .polylines = lines};
  options.tolerances.slit = 0.0101;
  EXPECT_TRUE(check(shapes::grid(2, 1), options).is_valid());
  options.tolerances.slit = 0.0099;
  const CheckResult result = check(shapes::grid(2, 1), options);
  EXPECT_EQ(result.unmatched_segments.size(), 6U);
  EXPECT_EQ(result.unmatched_border_edges.size(), 6U);
}

TEST(CheckPair, MeshesApartHaveNoClash) {
  EXPECT_TRUE(check_pair(shapes::cube(), shapes::cube(1.0, Vec3(2, 0, 0))).empty());
  EXPECT_TRUE(check_pair(shapes::cube(), Soup{}).empty());
}

TEST(CheckPair, MeshesThatMeetClash) {
  EXPECT_FALSE(check_pair(shapes::cube(), shapes::cube(1.0, Vec3(0.5, 0.5, 0.5))).empty());
  // Contact is enough.
  EXPECT_FALSE(check_pair(shapes::cube(), shapes::cube(1.0, Vec3(1, 0, 0))).empty());
}

TEST(Check, PolylineThatIsNotFiniteIsRefused) {
  for (const double wrong : {kNaN, kInfinity}) {
    const std::vector<Polyline> lines{{{0, 0, 0}, {wrong, 0, 0}}};
    EXPECT_THROW(
        static_cast<void>(check(shapes::grid(1, 1), {.is_single_face = true, .polylines = lines})),
        InvalidArgument);
  }
}

// The largest tolerance is longer than any distance here.
TEST(Check, WithinAHugeToleranceEveryBorderMatches) {
  const std::vector<Polyline> far{{{-1e308, 0, 0}, {1e308, 0, 0}}};
  for (const double tolerance : {1e306, 1e307, 1e308, std::numeric_limits<double>::max()}) {
    const CheckResult result =
        check(shapes::grid(1, 1),
              {.tolerances = {.slit = tolerance}, .is_single_face = true, .polylines = far});
    const bool is_within = tolerance >= 1e308;
    EXPECT_EQ(result.unmatched_segments.empty(), is_within) << tolerance;
    EXPECT_EQ(result.unmatched_border_edges.empty(), is_within) << tolerance;
  }
}

TEST(Check, MeshWithAPositionThatIsNotFiniteIsCorruptAndMatchedWithNothing) {
  Soup soup = shapes::grid(2, 1);
  soup.positions[0].x() = kNaN;
  const std::vector<Polyline> lines = border_of_two_squares();
  const CheckResult result = check(soup, {.is_single_face = true, .polylines = lines});
  EXPECT_EQ(result.report.count(DefectCode::Corrupt), 1U);
  EXPECT_TRUE(result.unmatched_segments.empty());
  EXPECT_THROW(static_cast<void>(check_pair(soup, shapes::cube())), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
