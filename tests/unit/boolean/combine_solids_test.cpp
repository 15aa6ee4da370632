#include "meshalyzer/boolean/combine_solids.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "support/effort.h"
#include "support/no_lengths.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace meshalyzer {
namespace {

double volume(const CombinedSolid& solid) {
  double six_times = 0.0;
  for (const CombinedFace& face : solid.faces) {
    const auto& [a, b, c] = face.corners;
    six_times += solid.positions[a].dot(solid.positions[b].cross(solid.positions[c]));
  }
  return six_times / 6.0;
}

CombinedSolid combine(const std::vector<Soup>& meshes, const InsideRule& rule) {
  const Soup all = concatenate(meshes);
  return combine_solids(operands_of(all, meshes), rule);
}

TEST(CombineSolids, CubesThatOverlapInACornerAreUnitedCutAndSubtracted) {
  const std::vector<Soup> cubes{shapes::cube(2), shapes::cube(2, {1, 1, 1})};
  EXPECT_EQ(volume(combine(cubes, union_rule())), 15.0);
  EXPECT_EQ(volume(combine(cubes, intersection_rule())), 1.0);
  EXPECT_EQ(volume(combine(cubes, difference_rule())), 7.0);
}

TEST(WholeFace, IsFoundWhateverVerticesAreAtItsCornersAndWhicheverIsFirst) {
  // The second box stands on the first, so that its lower vertices become those of the first.
  const std::vector<Soup> boxes{shapes::cube(2), shapes::cube(2, {0, 0, 2})};
  const Soup all = concatenate(boxes);
  CombinedSolid solid = combine_solids(operands_of(all, boxes), union_rule());
  // Of each box the wall between them goes.
  ASSERT_EQ(solid.faces.size(), 20U);
  for (CombinedFace& face : solid.faces) {
    std::rotate(face.corners.begin(), face.corners.begin() + 1, face.corners.end());
    const std::optional<Triangle> corners = whole_face(solid, all, face);
    ASSERT_TRUE(corners.has_value());
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(solid.positions[(*corners)[k]], all.positions[all.triangles[face.origin][k]]);
    }
  }
}

TEST(WholeFace, PartOfAFaceIsNone) {
  const std::vector<Soup> cubes{shapes::cube(2), shapes::cube(2, {1, 1, 1})};
  const Soup all = concatenate(cubes);
  const CombinedSolid solid = combine_solids(operands_of(all, cubes), difference_rule());
  double whole = 0.0;
  for (const CombinedFace& face : solid.faces) {
    if (!whole_face(solid, all, face)) continue;
    const auto [a, b, c] = corners_of(all, face.origin);
    whole += (b - a).cross(c - a).norm() / 2.0;
  }
  // Of each cube three sides are not cut; those of the second one are outside.
  EXPECT_EQ(whole, 12.0);
}

TEST(CombineSolids, FacesThatMeetNothingStay) {
  const std::vector<Soup> meshes{shapes::icosphere(3), shapes::cube(1, {0.5, -0.5, -0.5})};
  const Soup all = concatenate(meshes);
  const CombinedSolid solid = combine_solids(operands_of(all, meshes), union_rule());
  EXPECT_EQ(solid.outcome, CombineOutcome::Done);
  std::size_t n_same = 0;
  for (const CombinedFace& face : solid.faces) {
    EXPECT_FALSE(face.is_turned);
    if (face.corners == all.triangles[face.origin]) ++n_same;
  }
  // A cube of side 1 meets few of the 1280 faces of the sphere.
  EXPECT_GT(n_same, 1000U);
  EXPECT_GT(solid.n_pairs, 0U);
  EXPECT_LT(solid.largest_move, 1e-15);
}

TEST(CombineSolids, LargestMoveScalesWithSolidsWhoseSquaresUnderflow) {
  const auto largest_move = [](double scale) {
    return combine({shapes::scaled(shapes::icosphere(1), scale),
                    shapes::scaled(shapes::cube(1, {0.5, -0.5, -0.5}), scale)},
                   union_rule())
        .largest_move;
  };
  // A power of two changes no rounding.
  const double scale = std::ldexp(1.0, -600);
  EXPECT_GT(largest_move(1.0), 0.0);
  EXPECT_DOUBLE_EQ(largest_move(scale) / scale, largest_move(1.0));
}

TEST(CombineSolids, WhatIsTakenAwayLeavesItsFacesTurned) {
  const std::vector<Soup> meshes{shapes::cube(3), shapes::cube(1, {1, 1, 1})};
  const CombinedSolid solid = combine(meshes, difference_rule());
  EXPECT_EQ(volume(solid), 26.0);
  ASSERT_EQ(solid.faces.size(), 24U);
  for (const CombinedFace& face : solid.faces) EXPECT_EQ(face.is_turned, face.origin >= 12);
}

TEST(CombineSolids, SolidsThatDoNotMeetHaveNothingInCommon) {
  const std::vector<Soup> meshes{shapes::cube(), shapes::cube(1, {3, 0, 0})};
  EXPECT_TRUE(combine(meshes, intersection_rule()).faces.empty());
  EXPECT_EQ(combine(meshes, union_rule()).faces.size(), 24U);
  EXPECT_EQ(combine(meshes, difference_rule()).faces.size(), 12U);
}

TEST(CombineSolids, CommonWallOfAUnionGoesAndThatOfADifferenceStays) {
  const std::vector<Soup> meshes{shapes::cube(), shapes::cube(1, {1, 0, 0})};
  const CombinedSolid both = combine(meshes, union_rule());
  EXPECT_EQ(volume(both), 2.0);
  // Ten faces of each cube stay, none of them cut.
  EXPECT_EQ(both.faces.size(), 20U);
  EXPECT_EQ(volume(combine(meshes, difference_rule())), 1.0);
  EXPECT_TRUE(combine(meshes, intersection_rule()).faces.empty());
}

TEST(CombineSolids, OperandMayIntersectItself) {
  const std::vector<Soup> meshes{shapes::merged(shapes::cube(2), shapes::cube(2, {1, 1, 1})),
                                 shapes::cube(1, {10, 0, 0})};
  EXPECT_EQ(volume(combine(meshes, union_rule())), 16.0);
}

TEST(CombineSolids, CavityOfAnOperandStaysACavity) {
  const std::vector<Soup> meshes{shapes::nested_cubes(shapes::InnerShell::Cavity),
                                 shapes::cube(1, {-1, 0, 0})};
  const CombinedSolid solid = combine(meshes, union_rule());
  EXPECT_EQ(volume(solid), 27.0);
  // The solid that fills the cavity removes its wall.
  EXPECT_EQ(volume(combine({meshes[0], shapes::cube(1, {1, 1, 1})}, union_rule())), 27.0);
}

TEST(CombineSolids, AnyRuleOnWindingNumbersWill) {
  const std::vector<Soup> meshes{shapes::cube(2), shapes::cube(2, {1, 0, 0}),
                                 shapes::cube(2, {0, 1, 0})};
  // In exactly one: 2 x 3 unit columns of height 2, of which three are in several.
  const CombinedSolid solid = combine(
      meshes, [](auto windings) { return std::count(windings.begin(), windings.end(), 1) == 1; });
  // The cubes cover the columns (0,0) 1, (1,0) 2, (2,0) 1, (0,1) 2, (1,1) 3, (2,1) 1, (0,2) 1,
  // (1,2) 1 times.
  EXPECT_EQ(volume(solid), 10.0);
}

TEST(CombineSolids, FaceOfNoAreaIsLeftOut) {
  Soup cube = shapes::cube(2);
  // The middle of an edge: a face of no area beside it, so that the mesh stays closed.
  const Triangle first = cube.triangles[0];
  const auto middle = static_cast<Index>(cube.n_vertices());
  cube.positions.push_back((cube.positions[first[0]] + cube.positions[first[1]]) / 2);
  cube.triangles[0] = {first[0], middle, first[2]};
  cube.triangles.push_back({middle, first[1], first[2]});
  cube.triangles.push_back({first[0], first[1], middle});
  const CombinedSolid solid = combine({cube, shapes::cube(2, {1, 1, 1})}, union_rule());
  EXPECT_EQ(solid.outcome, CombineOutcome::Done);
  EXPECT_EQ(volume(solid), 15.0);
}

TEST(CombineSolids, AnyNumberOfThreadsGivesTheSame) {
  const std::vector<Soup> meshes{shapes::icosphere(4), shapes::torus(1, 0.4, 60, 30)};
  const auto run = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return as_soup(combine(meshes, difference_rule()));
  };
  const Soup one = run(1);
  for (const std::size_t threads : {2U, 7U}) {
    const Soup many = run(threads);
    EXPECT_EQ(many.positions, one.positions);
    EXPECT_EQ(many.triangles, one.triangles);
  }
}

TEST(CombineSolids, TooManyPairsAreNotCut) {
  const std::vector<Soup> meshes{shapes::cube(2), shapes::cube(2, {1, 1, 1})};
  const Soup all = concatenate(meshes);
  const Operands operands = operands_of(all, meshes);
  const std::size_t n = combine_solids(operands, union_rule()).n_pairs;
  CombineOptions options{.max_pairs = n};
  EXPECT_EQ(combine_solids(operands, union_rule(), options).outcome, CombineOutcome::Done);
  options.max_pairs = n - 1;
  const CombinedSolid left = combine_solids(operands, union_rule(), options);
  EXPECT_EQ(left.outcome, CombineOutcome::TooManyPairs);
  EXPECT_EQ(left.faces.size(), 24U);
}

TEST(CombineSolids, FacesThatWouldBeCutAtTooManyCrossingsAreNotCut) {
  // Inside each of the six large faces two lines of one of the other plates cross two of the other.
  const std::vector<Soup> plates{shapes::box({-3, -3, -1}, {3, 3, 1}),
                                 shapes::box({-3, -1, -4}, {3, 1, 4}),
                                 shapes::box({-1, -4, -4}, {1, 4, 4})};
  const Soup all = concatenate(plates);
  const Operands operands = operands_of(all, plates);
  CombineOptions options{.max_crossings = 100};
  EXPECT_EQ(combine_solids(operands, union_rule(), options).outcome, CombineOutcome::Done);
  options.max_crossings = 3;
  const CombinedSolid left = combine_solids(operands, union_rule(), options);
  EXPECT_EQ(left.outcome, CombineOutcome::TooManyPoints);
  EXPECT_EQ(left.faces.size(), all.n_faces());
}

TEST(CombineSolids, StopsWhenAsked) {
  const std::vector<Soup> meshes{shapes::cube(2), shapes::cube(2, {1, 1, 1})};
  const Soup all = concatenate(meshes);
  const CombineOptions options{.wants_to_stop = [] { return true; }};
  EXPECT_EQ(combine_solids(operands_of(all, meshes), union_rule(), options).outcome,
            CombineOutcome::Stopped);
}

TEST(CombineSolids, EndsWithinARoundWhenItIsToStop) {
  const std::vector<Soup> meshes{shapes::uv_sphere(12, 20),
                                 shapes::translated(shapes::uv_sphere(12, 20), {0.1, 0.2, 0.3})};
  const Soup all = concatenate(meshes);
  std::atomic<std::size_t> n_asked = 0;
  const auto outcome_after = [&](std::size_t n_allowed) {
    n_asked = 0;
    CombineOptions options;
    options.wants_to_stop = [&, n_allowed] { return ++n_asked > n_allowed; };
    return combine_solids(operands_of(all, meshes), union_rule(), options).outcome;
  };
  ASSERT_EQ(outcome_after(1'000'000), CombineOutcome::Done);
  const std::size_t n_in_all = n_asked;
  EXPECT_GE(n_in_all, 20U);
  test::Effort effort;
  for (std::size_t n_allowed = 0; n_allowed < n_in_all; ++n_allowed) {
    if (!effort.runs_next()) continue;
    EXPECT_EQ(outcome_after(n_allowed), CombineOutcome::Stopped) << n_allowed;
  }
}

TEST(CombineSolids, FaceOfNoOperandIsRefused) {
  const Soup soup = shapes::cube();
  const auto combine_as = [&](std::vector<Index> of_face, std::size_t count) {
    return combine_solids({soup, std::move(of_face), count}, union_rule());
  };
  EXPECT_THROW(static_cast<void>(combine_as({}, 1)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(combine_as(std::vector<Index>(12, 1), 1)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(combine_as(std::vector<Index>(12, 0), 0)), InvalidArgument);
}

TEST(CombineSolids, FaceOfAVertexThatTheSoupDoesNotHaveIsRefused) {
  Soup soup = shapes::cube();
  soup.triangles[3][1] = 1'000'000'000;
  EXPECT_THROW(
      static_cast<void>(combine_solids({soup, std::vector<Index>(12, 0), 1}, union_rule())),
      InvalidArgument);
}

TEST(CombineSolids, DeviationThatIsNoLengthIsRefused) {
  const Soup soup = shapes::cube();
  for (const double no_length : test::kNoLengths) {
    EXPECT_THROW(static_cast<void>(
                     combine_solids(operands_of(soup), union_rule(), {.max_deviation = no_length})),
                 InvalidArgument)
        << no_length;
  }
}

TEST(CombineSolids, RuleThatIsNullIsRefusedWhateverItIsFor) {
  for (const Soup& soup : {Soup{}, shapes::cube()}) {
    EXPECT_THROW(static_cast<void>(combine_solids(operands_of(soup), InsideRule())),
                 InvalidArgument);
  }
}

// The complement of the cube, and everything.
TEST(CombineSolids, RuleByWhichTheResultWouldHaveNoEndIsRefused) {
  const Soup soup = shapes::cube();
  for (const InsideRule& rule : {InsideRule([](std::span<const int> w) { return w[0] <= 0; }),
                                 InsideRule([](std::span<const int>) { return true; })}) {
    EXPECT_THROW(static_cast<void>(combine_solids(operands_of(soup), rule)), InvalidArgument);
  }
}

}  // namespace
}  // namespace meshalyzer
