#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/replace/internal/replacements.h"
#include "support/effort.h"
#include "support/random_soups.h"
#include "support/run_pass.h"
#include "support/shapes.h"
#include "unit/repair/facets/mended_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

/// A run of a pass that is told to stop.
struct StoppedRun {
  std::size_t n_asked = 0;
  std::size_t n_operations = 0;
};

/// Runs a pass once. Each time that it asks whether to stop, except for the first few times, the
/// answer is yes.
StoppedRun run_stopped(const Soup& soup, const PassFunction& pass, std::size_t n_allowed) {
  const TrackedMesh tracked = track_mesh(soup);
  const PreparedMesh mesh(tracked.soup);
  const Tolerances tolerances = resolve_tolerances({}, box_of(soup));
  const RepairLimits limits = wide_limits(soup);
  PassInput input{soup, tracked, mesh, tolerances, limits};
  std::atomic<std::size_t> n_asked = 0;
  input.wants_to_stop = [&] { return ++n_asked > n_allowed; };
  const PassResult result = pass(input);
  return {n_asked, result.edits.n_operations};
}

StoppedRun run_to_the_end(const Soup& soup, const PassFunction& pass) {
  return run_stopped(soup, pass, 1'000'000'000);
}

/// Expects that a pass asks no more than a few times once it is to stop, wherever that is.
///
/// @param n_in_all  How often it asks if it is not to stop.
void expect_to_end_soon(const Soup& soup, const PassFunction& pass, std::size_t n_in_all,
                        std::size_t most_after) {
  const std::size_t step = std::max<std::size_t>(1, n_in_all / 50);
  test::Effort effort;
  for (std::size_t n_allowed = 0; n_allowed < n_in_all; n_allowed += step) {
    if (!effort.runs_next()) continue;
    EXPECT_LE(run_stopped(soup, pass, n_allowed).n_asked, n_allowed + most_after) << n_allowed;
  }
}

/// A sphere without the faces above a height.
Soup open_sphere(int subdivisions, double height) {
  Soup soup = shapes::icosphere(subdivisions);
  std::vector<Index> cap;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const Triangle& t = soup.triangles[f];
    if (std::all_of(t.begin(), t.end(), [&](Index v) { return soup.positions[v].z() > height; })) {
      cap.push_back(f);
    }
  }
  return shapes::without_faces(std::move(soup), cap);
}

Soup placed_at(Soup soup, const Vec3& by) {
  for (Vec3& p : soup.positions) p += by;
  return soup;
}

/// Spheres side by side, each without the faces above a height.
Soup open_spheres(int n, double distance, double height = 0.5) {
  Soup soup;
  for (int i = 0; i < n; ++i) {
    soup = shapes::merged(soup, placed_at(open_sphere(2, height), Vec3(distance * i, 0.0, 0.0)));
  }
  return soup;
}

PassResult fill_smoothly(const PassInput& input) {
  return hole_filling({.shape = FillShape::Smooth, .sheets = FillSheets::Yes})(input);
}

TEST(StopWithinPasses, FillingOfOneHoleEndsBetweenItsSteps) {
  const Soup soup = open_sphere(3, 0.3);
  // A patch is refined and faired twice, with four systems of equations each time.
  const StoppedRun whole = run_to_the_end(soup, fill_smoothly);
  EXPECT_GE(whole.n_asked, 10U);
  EXPECT_EQ(whole.n_operations, 1U);
  EXPECT_EQ(run_stopped(soup, fill_smoothly, 0).n_operations, 0U);
  expect_to_end_soon(soup, fill_smoothly, whole.n_asked, 16);
}

TEST(StopWithinPasses, FillingEndsBetweenHoles) {
  const Soup soup = open_spheres(40, 3.0);
  const StoppedRun whole = run_to_the_end(soup, fill_smoothly);
  EXPECT_EQ(whole.n_operations, 40U);
  EXPECT_LT(run_stopped(soup, fill_smoothly, 100).n_operations, 40U);
  // Some thirty holes are looked at together: each asks once, and those under way a few times more.
  expect_to_end_soon(soup, fill_smoothly, whole.n_asked, 100);
}

TEST(StopWithinPasses, MendingEndsBetweenFacets) {
  std::mt19937 random(7);
  Soup soup = shapes::icosphere(3);
  hurt(soup, 60, random);
  const StoppedRun whole = run_to_the_end(soup, mend_facets);
  EXPECT_GE(whole.n_asked, thin_faces(soup).size() / 2);
  EXPECT_GT(whole.n_operations, 10U);
  EXPECT_EQ(run_stopped(soup, mend_facets, 0).n_operations, 0U);
  expect_to_end_soon(soup, mend_facets, whole.n_asked, 4);
}

TEST(StopWithinPasses, WindingNumbersOfSurfacesEndBetweenThem) {
  const Soup soup = shapes::flipped(open_spheres(40, 3.0));
  const StoppedRun whole = run_to_the_end(soup, orient_outward);
  EXPECT_EQ(whole.n_operations, 40U);
  EXPECT_LT(run_stopped(soup, orient_outward, 20).n_operations, 40U);
  // Some sixteen regions are examined at once for what lies round them.
  EXPECT_GE(whole.n_asked, 40U);
}

TEST(StopWithinPasses, WindingNumbersOfFragmentsEndBetweenThem) {
  const Soup soup = open_spheres(40, 3.0);
  const auto drop = [](const PassInput& input) { return drop_fragments(input, Fragments::Debris); };
  EXPECT_GE(run_to_the_end(soup, drop).n_asked, 40U);
}

TEST(StopWithinPasses, WindingNumbersOfPiecesEndBetweenThem) {
  // Each sphere crosses the next: they form one open component, whose pieces are sampled.
  const Soup soup = open_spheres(30, 1.6, 0.9);
  const auto cut = [](const PassInput& input) { return cut_intersections(input, {}); };
  const StoppedRun whole = run_to_the_end(soup, cut);
  EXPECT_GE(whole.n_operations, 1U);
  // Asked before a round, after the arrangement and after the selection of each of its rounds, and
  // for every 256 samples.
  EXPECT_GE(whole.n_asked, 12U);
  EXPECT_EQ(run_stopped(soup, cut, 4).n_operations, 0U);
}

TEST(StopWithinPasses, ContoursEndBetweenFacesAndRounds) {
  const Soup soup = open_spheres(8, 1.6, 0.9);
  const auto replace = [](const PassInput& input) {
    return replace_broken_solids(input, {.max_deviation = 0.05}).result;
  };
  const StoppedRun whole = run_to_the_end(soup, replace);
  EXPECT_EQ(whole.n_operations, 1U);
  // Asked for every 64 faces, and before each round.
  EXPECT_GE(whole.n_asked, soup.n_faces() / 64 + 2);
  EXPECT_EQ(run_stopped(soup, replace, 0).n_operations, 0U);
  EXPECT_EQ(run_stopped(soup, replace, soup.n_faces() / 64 + 2).n_operations, 0U);
}

}  // namespace
}  // namespace meshalyzer
