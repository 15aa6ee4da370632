#include "meshalyzer/repair/driver/internal/acceptance.h"

#include "meshalyzer/repair/edits/apply_edits.h"
#include "support/run_pass.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Returns the acceptance of edits of a soup; distances do not matter unless they are limited.
std::vector<Rejection> harms_of(const Soup& soup, const Edits& edits,
                                const DefectCodes& may_create = {}, double max_deviation = 1e3) {
  const Tolerances tolerances = resolve_tolerances({}, box_of(soup));
  const RepairState before(track_mesh(soup), tolerances);
  TrackedMesh tracked = apply_edits(before.tracked(), edits);
  const AffectedElements affected =
      find_affected_elements(before.tracked(), edits, SkippedOperations({}), tracked);
  const RepairState after(std::move(tracked), tolerances, {before}, affected);
  const DeviationMeter meter(soup);
  return check_acceptance(before, after, affected, edits.n_operations,
                          {.input = soup,
                           .meter = meter,
                           .max_deviation = max_deviation,
                           .may_create = may_create})
      .rejections;
}

/// A square of two faces, their diagonal from (0, 0) to (1, 1).
Soup square() {
  return shapes::make({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
}

/// The same with the other diagonal.
Edits flip_of_square() {
  Edits edits;
  const Index op = edits.begin_operation();
  edits.changed_faces.push_back({op, 0, {0, 1, 3}});
  edits.changed_faces.push_back({op, 1, {1, 2, 3}});
  return edits;
}

/// Returns the acceptance of edits that must mend something.
std::vector<Rejection> progress_of(const Soup& soup, const Edits& edits,
                                   std::span<const std::uint8_t> skipped = {}) {
  const Tolerances tolerances = resolve_tolerances({}, box_of(soup));
  const RepairState before(track_mesh(soup), tolerances);
  TrackedMesh tracked = apply_edits(before.tracked(), edits, skipped);
  const AffectedElements affected =
      find_affected_elements(before.tracked(), edits, SkippedOperations(skipped), tracked);
  const RepairState after(std::move(tracked), tolerances, {before}, affected);
  const DeviationMeter meter(soup);
  return check_acceptance(before, after, affected, edits.n_operations,
                          {.input = soup,
                           .meter = meter,
                           .max_deviation = 1e3,
                           .may_create = {DefectCode::Hole},
                           .must_mend = true})
      .rejections;
}

/// The soup and a face more, with corners of its own.
Soup with_face(Soup soup, const Vec3& a, const Vec3& b, const Vec3& c) {
  return shapes::merged(soup, shapes::make({a, b, c}, {{0, 1, 2}}));
}

TEST(JudgeTrial, ChangeThatMeetsNothingIsHarmless) {
  EXPECT_EQ(harms_of(square(), flip_of_square()), std::vector{Rejection::None});
}

TEST(JudgeTrial, ChangeThatMustMendSomethingAndDoesNotIsRejected) {
  // Neither the four border edges nor a pair of faces that intersect become fewer.
  EXPECT_EQ(progress_of(square(), flip_of_square()), std::vector{Rejection::MendsNothing});
  const Soup crossed = with_face(square(), {0.9, 0.2, -1}, {0.9, 0.2, 1}, {1.0, 0.3, 1});
  EXPECT_EQ(progress_of(crossed, flip_of_square()), std::vector{Rejection::MendsNothing});
}

TEST(JudgeTrial, ChangeThatMakesPairsOrBordersFewerMendsSomething) {
  const Soup crossed = with_face(square(), {0.9, 0.2, -1}, {0.9, 0.2, 1}, {1.0, 0.3, 1});
  Edits drops_pair;
  drops_pair.removed_faces.push_back({drops_pair.begin_operation(), 0});
  EXPECT_EQ(progress_of(crossed, drops_pair), std::vector{Rejection::None});
  Soup open = shapes::cube();
  const Triangle lid = open.triangles.back();
  open.triangles.pop_back();
  Edits closes;
  closes.added_faces.push_back(
      {.op = closes.begin_operation(), .corners = lid, .prototype = 0, .fills_hole = true});
  EXPECT_EQ(progress_of(open, closes), std::vector{Rejection::None});
}

TEST(JudgeTrial, SkippedChangeNeedNotMendAnything) {
  Soup open = shapes::cube();
  const Triangle lid = open.triangles.back();
  open.triangles.pop_back();
  Edits edits;
  edits.added_faces.push_back(
      {.op = edits.begin_operation(), .corners = lid, .prototype = 0, .fills_hole = true});
  static_cast<void>(edits.begin_operation());
  const std::vector<std::uint8_t> skipped{0, 1};
  EXPECT_EQ(progress_of(open, edits, skipped), (std::vector{Rejection::None, Rejection::None}));
}

TEST(JudgeTrial, ContactPassedOnIsHarmless) {
  // A face that stands on the square at (0.9, 0.2), in face 0 before and in face 1 after; and one
  // that goes through it there.
  for (const double low : {0.0, -1.0}) {
    const Soup soup = with_face(square(), {0.9, 0.2, low}, {0.9, 0.2, 1}, {1.0, 0.3, 1});
    EXPECT_EQ(harms_of(soup, flip_of_square()), std::vector{Rejection::None});
  }
}

TEST(JudgeTrial, ContactThatSpreadsOverFacesOfAnOperationIsHarmless) {
  // On the edge at (1, 1), which one face has after the flip, and two before; and at (1, 0), where
  // it is the other way round.
  for (const Vec3& corner : {Vec3(1, 1, 0), Vec3(1, 0, 0)}) {
    const Soup soup = with_face(square(), corner, corner + Vec3(1, 0, 1), corner + Vec3(0, 1, 1));
    EXPECT_EQ(harms_of(soup, flip_of_square()), std::vector{Rejection::None});
  }
}

/// Moves the corner at (1, 1) up.
Edits lifted_corner() {
  Edits edits;
  edits.moved_vertices.push_back({edits.begin_operation(), 2, {1, 1, 1}});
  return edits;
}

TEST(JudgeTrial, ContactWithAFaceThatWasApartIsHarm) {
  // A triangle above the square, through which it comes up.
  const Soup soup = with_face(square(), {0.5, 0, 0.3}, {2, 0.5, 0.3}, {0.5, 2, 0.3});
  EXPECT_EQ(harms_of(soup, lifted_corner()), std::vector{Rejection::Intersects});
}

TEST(JudgeTrial, TouchThatBecomesACrossingIsHarm) {
  // It stands on face 1 at (0.2, 0.8); when the square is folded face 0 comes to pass through it.
  const Soup soup = with_face(square(), {0.2, 0.8, 0}, {0.9, 0.3, 0.6}, {0.9, 0.5, 0.9});
  ASSERT_EQ(RepairState(track_mesh(soup), resolve_tolerances({}, box_of(soup)))
                .mesh()
                .intersecting_pairs()
                .size(),
            1U);
  EXPECT_EQ(harms_of(soup, lifted_corner()), std::vector{Rejection::Intersects});
}

TEST(JudgeTrial, OnlyTheOperationThatMakesContactIsBlamed) {
  Soup soup = with_face(square(), {0.5, 0, 0.3}, {2, 0.5, 0.3}, {0.5, 2, 0.3});
  soup = shapes::merged(shapes::translated(square(), {9, 0, 0}), soup);
  Edits edits;
  edits.moved_vertices.push_back({edits.begin_operation(), 2, {10, 1, 1}});
  edits.moved_vertices.push_back({edits.begin_operation(), 6, {1, 1, 1}});
  EXPECT_EQ(harms_of(soup, edits), (std::vector{Rejection::None, Rejection::Intersects}));
}

TEST(JudgeTrial, ContactOfAnotherOperationIsNoExcuse) {
  // Two squares, one of them met by the triangle before: the other must not come to it.
  Soup soup = with_face(square(), {0.5, 0.2, -0.1}, {2, 0.5, 0.3}, {0.5, 2, 0.3});
  soup = shapes::merged(soup, shapes::translated(square(), {0.95, 0.95, -0.5}));
  Edits edits;
  edits.moved_vertices.push_back({edits.begin_operation(), 9, {1.2, 1.2, 1}});
  const Index flip = edits.begin_operation();
  edits.changed_faces.push_back({flip, 0, {0, 1, 3}});
  edits.changed_faces.push_back({flip, 1, {1, 2, 3}});
  EXPECT_EQ(harms_of(soup, edits), (std::vector{Rejection::Intersects, Rejection::None}));
}

TEST(JudgeTrial, FlawThatIsMadeIsHarmUnlessThePassMayMakeIt) {
  Edits edits;
  edits.removed_faces.push_back({edits.begin_operation(), 0});
  EXPECT_EQ(harms_of(shapes::cube(), edits), std::vector{Rejection::MoreDefects});
  EXPECT_EQ(harms_of(shapes::cube(), edits, {DefectCode::Hole}), std::vector{Rejection::None});
}

TEST(JudgeTrial, DistancesAreMeasuredOnlyIfNothingElseIsHarm) {
  // Without one side a cube has a hole, and the middle of that side is 1/2 from the others.
  Edits edits;
  const Index op = edits.begin_operation();
  for (const Index face : {0U, 1U}) edits.removed_faces.push_back({op, face});
  EXPECT_EQ(harms_of(shapes::cube(), edits, {}, 0.1), std::vector{Rejection::MoreDefects});
  EXPECT_EQ(harms_of(shapes::cube(), edits, {DefectCode::Hole}, 0.1),
            std::vector{Rejection::TooFar});
}

}  // namespace
}  // namespace meshalyzer
