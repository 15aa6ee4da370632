#include "meshalyzer/repair/driver/deviation.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/build.h"
#include "support/effort.h"
#include "support/random_soups.h"
#include "support/shapes.h"
#include "support/surface_distance.h"
#include "unit/repair/driver/tracked_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace meshalyzer {
namespace {

using Random = std::mt19937;
using Result = DeviationMeter::Result;

Result measure(const Soup& input, const TrackedMesh& tracked, double bound) {
  const PreparedMesh mesh(tracked.soup);
  return DeviationMeter(input).measure({tracked, mesh, bound});
}

TrackedMesh moved(const Soup& input, const Vec3& by) {
  TrackedMesh tracked = track_mesh(input);
  tracked.soup = shapes::translated(tracked.soup, by);
  return tracked;
}

/// The largest distance is known, and so the answer but for a thousandth of the bound.
void expect_largest(const Result& result, double expected, double bound) {
  EXPECT_TRUE(result.far.empty());
  EXPECT_GE(result.largest, expected * (1 - 1e-14));
  EXPECT_LE(result.largest, expected + 1e-3 * bound);
}

TEST(DeviationMeter, UnchangedMeshIsNowhereAway) {
  const Soup input = shapes::torus(2, 0.5, 20, 12);
  const Result result = measure(input, track_mesh(input), 0.0);
  EXPECT_TRUE(result.far.empty());
  EXPECT_EQ(result.largest, 0.0);
}

TEST(DeviationMeter, FacesTurnedOverOrBegunAtAnotherCornerAreTheSame) {
  const Soup input = shapes::torus(2, 0.5, 20, 12);
  TrackedMesh tracked = track_mesh(shapes::flipped(input));
  for (Triangle& t : tracked.soup.triangles) std::rotate(t.begin(), t.begin() + 1, t.end());
  const Result result = measure(input, tracked, 0.0);
  EXPECT_TRUE(result.far.empty());
  EXPECT_EQ(result.largest, 0.0);
}

TEST(DeviationMeter, RaisedPlaneIsAsFarAsItWasRaised) {
  const Soup input = shapes::grid(6, 5);
  const TrackedMesh tracked = moved(input, {0, 0, 0.25});
  expect_largest(measure(input, tracked, 0.25), 0.25, 0.25);
  expect_largest(measure(input, tracked, 10.0), 0.25, 10.0);
}

TEST(DeviationMeter, RaisedPlaneIsFarAllOverWhereTheBoundIsSmaller) {
  const Soup input = shapes::grid(6, 5);
  const Result result = measure(input, moved(input, {0, 0, 0.25}), 0.2499);
  EXPECT_EQ(result.far.of_input, face_range(0, 60));
  EXPECT_EQ(result.far.of_repaired, face_range(0, 60));
  EXPECT_GE(result.largest, 0.25);
}

TEST(DeviationMeter, MeasurementThatIsStoppedTakesForFarWhatIsNotMeasured) {
  const Soup input = shapes::grid(6, 5);
  // Only the ends are far.
  const TrackedMesh tracked = moved(input, {1, 0, 0.25});
  const PreparedMesh mesh(tracked.soup);
  const DeviationMeter meter(input);
  const FarFaces ends = meter.find_far({.tracked = tracked, .mesh = mesh, .bound = 0.4});
  EXPECT_LT(ends.of_input.size(), 60U);
  EXPECT_LT(ends.of_repaired.size(), 60U);
  const FarFaces far = meter.find_far(
      {.tracked = tracked, .mesh = mesh, .bound = 0.4, .wants_to_stop = [] { return true; }});
  EXPECT_EQ(far.of_input, face_range(0, 60));
  EXPECT_EQ(far.of_repaired, face_range(0, 60));
}

TEST(DeviationMeter, PlaneMovedAlongItselfIsFarOnlyAtItsEnds) {
  // The strip of the old one that the new one leaves, and the other way round; elsewhere both lie
  // over each other, with all faces changed.
  const Soup input = shapes::grid(7, 6);
  const TrackedMesh tracked = moved(input, {0.3, 0.07, 0});
  const double at_corner = std::hypot(0.3, 0.07);
  expect_largest(measure(input, tracked, 0.35), at_corner, 0.35);
  const Result result = measure(input, tracked, 0.29);
  // 2 x 6 faces stand at either end.
  EXPECT_LE(result.far.of_input.size(), 12u);
  EXPECT_GE(result.far.of_input.size(), 6u);
}

TEST(DeviationMeter, PlaneCutIntoOtherFacesIsNowhereAway) {
  // Two large faces instead of many small ones.
  const Soup input = shapes::grid(12, 12);
  TrackedMesh tracked = without_faces(track_mesh(input), face_range(0, 288));
  add_face(tracked, {0, 12, 168}, 0);
  add_face(tracked, {0, 168, 156}, 1);
  expect_largest(measure(input, tracked, 0.01), 0.0, 0.01);
}

TEST(DeviationMeter, HoleUnderALargeFaceIsFoundWhereverItIs) {
  // The middle of a square hole of two by two is 1 away from its rim.
  const Soup fine = shapes::grid(7, 6);
  for (Index x = 1; x < 5; ++x) {
    for (Index y = 1; y < 4; ++y) {
      TrackedMesh tracked = track_mesh(shapes::make(fine.positions, {{0, 7, 55}, {0, 55, 48}}));
      const Soup input = tracked.soup;
      tracked = without_faces(tracked, {0, 1});
      for (const Triangle& t : fine.triangles) {
        const Vec3 middle =
            (fine.positions[t[0]] + fine.positions[t[1]] + fine.positions[t[2]]) / 3 -
            Vec3(x, y, 0);
        const bool is_in_hole = middle.minCoeff() >= 0 && middle.maxCoeff() <= 2;
        if (!is_in_hole) add_face(tracked, t, 0);
      }
      expect_largest(measure(input, tracked, 1.2), 1.0, 1.2);
      EXPECT_FALSE(measure(input, tracked, 0.9).far.empty());
    }
  }
}

TEST(DeviationMeter, FlippedDiagonalOfAFlatSquareIsNowhereAway) {
  const Soup input =
      shapes::make({{0, 0, 1}, {1, 0.1, 1}, {1.3, 1, 1}, {0, 1, 1}}, {{0, 1, 2}, {0, 2, 3}});
  TrackedMesh tracked = track_mesh(input);
  tracked.soup.triangles = {{0, 1, 3}, {1, 2, 3}};
  expect_largest(measure(input, tracked, 1e-6), 0.0, 1e-6);
  expect_largest(measure(input, tracked, 2.0), 0.0, 2.0);
}

TEST(DeviationMeter, BumpThatIsLevelledWasAsFarAsItWasHigh) {
  Soup input = shapes::grid(8, 8);
  const std::size_t top = 4 * 9 + 4;
  input.positions[top].z() = 0.7;
  TrackedMesh tracked = track_mesh(input);
  tracked.soup.positions[top].z() = 0.0;
  expect_largest(measure(input, tracked, 1.0), 0.7, 1.0);
  const Result result = measure(input, tracked, 0.6);
  // All six faces round the top reach up to it, and nothing else changed.
  EXPECT_EQ(result.far.of_input.size(), 6u);
  EXPECT_GE(result.largest, 0.7);
}

TEST(DeviationMeter, CapThatIsCutOffASphereWasAsFarAsItWasHigh) {
  // The pole sinks into the plane of the first ring.
  const Soup input = shapes::uv_sphere(10, 16);
  TrackedMesh tracked = track_mesh(input);
  const auto pole = std::max_element(tracked.soup.positions.begin(), tracked.soup.positions.end(),
                                     [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  pole->z() = std::cos(std::numbers::pi / 10);
  expect_largest(measure(input, tracked, 0.06), 1 - std::cos(std::numbers::pi / 10), 0.06);
}

TEST(DeviationMeter, DuplicatesThatAreDroppedAreNowhereAway) {
  Soup input = shapes::icosphere(2);
  for (Index f = 0; f < 40; ++f) {
    const Triangle t = input.triangles[7 * f];
    input.triangles.push_back({t[1], t[0], t[2]});
  }
  const Result result = measure(input, without_faces(track_mesh(input), face_range(320, 360)), 0.0);
  EXPECT_TRUE(result.far.empty());
  EXPECT_EQ(result.largest, 0.0);
}

TEST(DeviationMeter, ComponentThatIsRemovedWasAsFarAsItsFarSide) {
  const Soup input = shapes::merged(shapes::cube(), shapes::cube(1.0, {5, 0, 0}));
  const TrackedMesh tracked = without_faces(track_mesh(input), face_range(12, 24));
  expect_largest(measure(input, tracked, 6.0), 5.0, 6.0);
  const Result result = measure(input, tracked, 0.1);
  EXPECT_EQ(result.far.of_input, face_range(12, 24));
  EXPECT_TRUE(result.far.of_repaired.empty());
  EXPECT_GE(result.largest, 5.0);
}

/// The unit cube and one face of another one, five away.
TrackedMesh with_new_face(const Soup& input, Index origin) {
  TrackedMesh tracked = track_mesh(input);
  tracked.soup.positions.insert(tracked.soup.positions.end(), {{6, 0, 0}, {6, 1, 0}, {6, 0, 1}});
  add_face(tracked, {8, 9, 10}, origin);
  return tracked;
}

TEST(DeviationMeter, LostFacesDoNotCount) {
  const Soup input = shapes::merged(shapes::cube(), shapes::cube(1, {5, 0, 0}));
  const TrackedMesh tracked = without_faces(track_mesh(input), face_range(12, 24));
  const PreparedMesh mesh(tracked.soup);
  const Faces lost = face_range(12, 24);
  const DeviationMeter meter(input);
  const DeviationMeter::Repaired all{.tracked = tracked, .mesh = mesh, .bound = 1, .lost = lost};
  EXPECT_EQ(meter.measure(all).largest, 0.0);
  EXPECT_TRUE(meter.find_far(all).empty());
  const Faces fewer = face_range(12, 23);
  const FarFaces far =
      meter.find_far({.tracked = tracked, .mesh = mesh, .bound = 1, .lost = fewer});
  EXPECT_EQ(far.of_input, Faces{23});
}

/// The segments are measured by the triangle whose edge they lie on, and lost with it.
TEST(DeviationMeter, SegmentsOnLostFacesDoNotCount) {
  Soup input = shapes::cube();
  input.positions.insert(input.positions.end(), {{5, 0, 0}, {7, 0, 0}, {5, 1, 0}, {6, 0, 0}});
  input.triangles.insert(input.triangles.end(), {{8, 9, 10}, {9, 8, 11}, {8, 11, 9}});
  const TrackedMesh tracked = without_faces(track_mesh(input), face_range(12, 15));
  const PreparedMesh mesh(tracked.soup);
  const DeviationMeter meter(input);
  const FarFaces far = meter.find_far({.tracked = tracked, .mesh = mesh, .bound = 1});
  EXPECT_EQ(far.of_input, Faces{12});
  EXPECT_TRUE(
      meter.find_far({.tracked = tracked, .mesh = mesh, .bound = 1, .lost = far.of_input}).empty());
}

TEST(DeviationMeter, FacesThatAreWallsDoNotCountWhereverTheirCornersBegin) {
  // Some coordinates are 0, which equals -0.
  const Soup input = shapes::merged(shapes::cube(1, {5, 0, 0}), shapes::cube());
  const TrackedMesh tracked = without_faces(track_mesh(input), face_range(12, 24));
  const PreparedMesh mesh(tracked.soup);
  std::vector<InteriorWall> walls;
  for (Index face = 12; face < 24; ++face) {
    const auto [a, b, c] = corners_of(input, face);
    // Nothing tells which face a wall is a part of.
    walls.push_back({face % 2 == 0 ? Corners{c, a, b} : Corners{b, a, c}});
    for (Vec3& p : walls.back().corners) p = p.unaryExpr([](double x) { return x == 0 ? -x : x; });
  }
  const DeviationMeter meter(input);
  DeviationMeter::Repaired repaired{.tracked = tracked, .mesh = mesh, .bound = 0.1, .walls = walls};
  EXPECT_EQ(meter.measure(repaired).largest, 0.0);
  repaired.walls = std::span(walls).first(11);
  EXPECT_EQ(meter.find_far(repaired).of_input, Faces{23});
}

TEST(DeviationMeter, FaceIsWhereItsPartsAre) {
  // A triangle in four parts: two of them faces, two walls. Another face lies beside it.
  const Soup input = shapes::make(
      {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {9, 9, 9}, {9, 8, 9}, {8, 9, 9}}, {{3, 4, 5}, {0, 1, 2}});
  TrackedMesh tracked = without_faces(track_mesh(input), Faces{1});
  tracked.soup.positions.insert(tracked.soup.positions.end(), {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  add_face(tracked, {0, 6, 8}, 1);
  add_face(tracked, {6, 1, 7}, 1);
  const auto at = [&](Index v) { return tracked.soup.positions[v]; };
  std::vector<InteriorWall> walls{{{at(8), at(7), at(2)}, 1}, {{at(6), at(7), at(8)}, 1}};
  const PreparedMesh mesh(tracked.soup);
  const DeviationMeter meter(input);
  EXPECT_EQ(
      meter.measure({.tracked = tracked, .mesh = mesh, .bound = 1e-3, .walls = walls}).largest,
      0.0);
  walls.pop_back();
  EXPECT_EQ(
      meter.find_far({.tracked = tracked, .mesh = mesh, .bound = 1e-3, .walls = walls}).of_input,
      Faces{1});
}

TEST(DeviationMeter, NewSurfaceIsAsFarAsItsFarSide) {
  const Soup input = shapes::cube();
  const TrackedMesh tracked = with_new_face(input, 3);
  expect_largest(measure(input, tracked, 6.0), 5.0, 6.0);
  const Result result = measure(input, tracked, 4.9);
  EXPECT_TRUE(result.far.of_input.empty());
  EXPECT_EQ(result.far.of_repaired, Faces{12});
}

TEST(DeviationMeter, HolePatchesMayBeAnywhere) {
  const Soup input = shapes::cube();
  const Result result = measure(input, with_new_face(input, kNoIndex), 0.1);
  EXPECT_TRUE(result.far.empty());
  EXPECT_EQ(result.largest, 0.0);
}

TEST(DeviationMeter, HolePatchIsSurfaceToOldFaces) {
  const Soup input = shapes::cube();
  TrackedMesh tracked = without_faces(track_mesh(input), {0});
  EXPECT_FALSE(measure(input, tracked, 0.01).far.empty());
  add_face(tracked, input.triangles[0], kNoIndex);
  EXPECT_EQ(measure(input, tracked, 0.01).largest, 0.0);
}

TEST(DeviationMeter, FaceOfZeroAreaCountsAsItsSegment) {
  Soup input = shapes::cube();
  input.positions.insert(input.positions.end(), {{1, 1, 1}, {1, 1, 2}, {1, 1, 3}});
  input.triangles.push_back({8, 9, 10});
  const TrackedMesh tracked = without_faces(track_mesh(input), {12});
  expect_largest(measure(input, tracked, 2.5), 2.0, 2.5);
  EXPECT_EQ(measure(input, tracked, 1.0).far.of_input, Faces{12});
}

TEST(DeviationMeter, FacesInNoComplexAreNotMeasured) {
  Soup input = shapes::cube();
  input.positions.emplace_back(9, 9, 9);
  input.triangles.push_back({8, 8, 0});
  input.triangles.push_back({8, 1, kNoIndex});
  EXPECT_EQ(measure(input, without_faces(track_mesh(input), {12, 13}), 0.1).largest, 0.0);
}

TEST(DeviationMeter, WhereNothingIsLeftAllIsInfinitelyFar) {
  const Soup input = shapes::cube();
  const Result gone = measure(input, without_faces(track_mesh(input), face_range(0, 12)), 100.0);
  EXPECT_EQ(gone.far.of_input, face_range(0, 12));
  EXPECT_EQ(gone.largest, std::numeric_limits<double>::infinity());
  // Faces out of nothing.
  const Soup empty = shapes::make(input.positions, {});
  TrackedMesh tracked = track_mesh(empty);
  add_face(tracked, input.triangles[0], 0);
  tracked.n_input_faces = 1;
  tracked.face_keys = {0};
  const Soup degenerate = shapes::make(input.positions, {{0, 0, 1}});
  const Result made = measure(degenerate, tracked, 100.0);
  EXPECT_EQ(made.far.of_repaired, Faces{0});
  EXPECT_EQ(made.largest, std::numeric_limits<double>::infinity());
}

TEST(DeviationMeter, BoundOfZeroLetsNothingMove) {
  const Soup input = shapes::icosphere(2);
  TrackedMesh tracked = track_mesh(input);
  tracked.soup.positions[5] *= 1.0 + 1e-12;
  const Result result = measure(input, tracked, 0.0);
  EXPECT_FALSE(result.far.of_input.empty());
  EXPECT_FALSE(result.far.of_repaired.empty());
}

/// Damages of all kinds that a repair might do, except that it would do less.
TrackedMesh mangled(const Soup& input, double size, Random& random) {
  std::uniform_real_distribution<> real(-size, size);
  TrackedMesh tracked = track_mesh(input);
  for (Vec3& p : tracked.soup.positions) {
    if (below(random, 6) == 0) p += Vec3(real(random), real(random), real(random));
  }
  const auto n = static_cast<Index>(input.n_vertices());
  for (Triangle& t : tracked.soup.triangles) {
    // A corner goes elsewhere, mostly to a vertex near by.
    if (below(random, 20) == 0) t[below(random, 3)] = (t[0] + below(random, 3)) % n;
  }
  Faces gone;
  for (Index f = 0; f < input.n_faces(); ++f) {
    if (below(random, 20) == 0) gone.push_back(f);
  }
  return without_faces(tracked, gone);
}

/// The meter's answer lies between what dense samples find and what they cannot have missed.
void expect_as_sampled(const Soup& input, const TrackedMesh& tracked) {
  constexpr double kSpacing = 0.03;
  const double sampled = std::max(test::sampled_distance(input, tracked.soup, kSpacing),
                                  test::sampled_distance(tracked.soup, input, kSpacing));
  const double bound = 2 * (sampled + kSpacing);
  const Result result = measure(input, tracked, bound);
  EXPECT_TRUE(result.far.empty());
  EXPECT_GE(result.largest, sampled - 1e-14);
  EXPECT_LE(result.largest, sampled + kSpacing + 1e-3 * bound);
  EXPECT_FALSE(measure(input, tracked, 0.999 * sampled).far.empty());
  EXPECT_TRUE(measure(input, tracked, 1.002 * result.largest).far.empty());
}

TEST(DeviationMeter, AgreesWithDenseSamplesOnMangledMeshes) {
  Random random(3);
  const std::vector<Soup> inputs{shapes::torus(1, 0.4, 12, 7), shapes::icosphere(1), shapes::cube(),
                                 shapes::grid(4, 3)};
  const std::vector<double> sizes{0.01, 0.1, 1.0};
  for (std::size_t i = 0; i < inputs.size() * sizes.size(); i += test::one_of()) {
    SCOPED_TRACE(i);
    const Soup& input = inputs[i % inputs.size()];
    expect_as_sampled(input, mangled(input, sizes[i / inputs.size()], random));
  }
}

TEST(DeviationMeter, FarFacesAreThoseThatDenseSamplesFindFar) {
  Random random(4);
  const Soup input = shapes::torus(1, 0.4, 16, 9);
  const double spacing = 0.02;
  const double bound = 0.05;
  const TrackedMesh tracked = mangled(input, 0.1, random);
  const Result result = measure(input, tracked, bound);
  for (Index f = 0; f < input.n_faces(); f += static_cast<Index>(test::one_of())) {
    const Soup face = shapes::make(input.positions, {input.triangles[f]});
    const double sampled = test::sampled_distance(face, tracked.soup, spacing);
    const bool is_far =
        std::binary_search(result.far.of_input.begin(), result.far.of_input.end(), f);
    EXPECT_TRUE(is_far || sampled <= bound) << f;
    EXPECT_TRUE(!is_far || sampled + spacing > 0.998 * bound) << f;
  }
  EXPECT_GT(result.far.of_input.size(), 5u);
}

TEST(DeviationMeter, SizeOfTheMeshDoesNotMatter) {
  Random random(5);
  const Soup input = shapes::icosphere(1);
  const TrackedMesh tracked = mangled(input, 0.1, random);
  const double expected = measure(input, tracked, 3.0).largest;
  for (const double scale : {1e-300, 1e-150, 1e150, 1e300}) {
    SCOPED_TRACE(scale);
    TrackedMesh scaled = tracked;
    scaled.soup = shapes::scaled(tracked.soup, scale);
    const Result result = measure(shapes::scaled(input, scale), scaled, 3.0 * scale);
    EXPECT_TRUE(result.far.empty());
    EXPECT_NEAR(result.largest / scale, expected, 3e-3);
  }
}

TEST(DeviationMeter, HugeAndTinyMeshesEnd) {
  Random random(6);
  for (const double scale : {1e-320, 1e307}) {
    const Soup input = shapes::scaled(shapes::icosphere(1), scale);
    TrackedMesh tracked = mangled(input, 0.1 * scale, random);
    EXPECT_FALSE(std::isnan(measure(input, tracked, 0.01 * scale).largest));
    EXPECT_FALSE(std::isnan(measure(input, tracked, 1.0).largest));
  }
}

TEST(DeviationMeter, ThreadCountDoesNotMatter) {
  Random random(7);
  const Soup input = shapes::torus(2, 0.5, 60, 40);
  const TrackedMesh tracked = mangled(input, 0.02, random);
  const ThreadLimit two(2);
  const Result by_two = measure(input, tracked, 0.01);
  const ThreadLimit one(1);
  const Result by_one = measure(input, tracked, 0.01);
  EXPECT_EQ(by_one.largest, by_two.largest);
  EXPECT_EQ(by_one.far.of_input, by_two.far.of_input);
  EXPECT_EQ(by_one.far.of_repaired, by_two.far.of_repaired);
  EXPECT_FALSE(by_one.far.empty());
}

}  // namespace
}  // namespace meshalyzer
