#include "meshalyzer/repair/driver/deviation.h"
#include "support/shapes.h"
#include "unit/repair/driver/tracked_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// A mesh in which two faces in three are new, near those that they were made of, and some of its
/// faces are then removed or moved away.
struct TwoSteps {
  TrackedMesh first;
  TrackedMesh second;
  std::vector<std::uint8_t> is_new;
  std::vector<Corners> gone;
};

TwoSteps two_steps(const Soup& input, double bound, std::mt19937& random) {
  TwoSteps steps{.first = track_mesh(input), .second = {}, .is_new = {}, .gone = {}};
  for (Vec3& p : steps.first.soup.positions) {
    if (random() % 3 == 0) continue;
    p *= 1.0 + 0.2 * bound * static_cast<double>(random() % 5);
  }
  steps.second = steps.first;
  std::vector<std::uint8_t> is_moved(input.n_vertices(), 0);
  for (int i = 0; i < 2; ++i) {
    const auto v = static_cast<Index>(random() % input.n_vertices());
    steps.second.soup.positions[v] *= 1.0 + bound * static_cast<double>(random() % 4);
    is_moved[v] = 1;
  }
  const auto first_removed = static_cast<Index>(random() % (input.n_faces() - 2));
  for (Index face = 0; face < input.n_faces(); ++face) {
    const Triangle& t = input.triangles[face];
    const bool moves = std::any_of(t.begin(), t.end(), [&](Index v) { return is_moved[v] != 0; });
    const bool is_removed = face == first_removed || face == first_removed + 1;
    if (moves || is_removed) steps.gone.push_back(corners_of(steps.first.soup, face));
    if (!is_removed) steps.is_new.push_back(moves ? 1 : 0);
  }
  steps.second = without_faces(std::move(steps.second), {first_removed, first_removed + 1});
  return steps;
}

TEST(DeviationMeterStep, FarFacesAreThoseOfTheWholeSurface) {
  std::mt19937 random(11);
  const Soup input = shapes::torus(2, 0.5, 20, 12);
  // A torus of this size has edges of 0.3 to 0.8: the bound is smaller, or reaches some faces far.
  std::size_t n_far = 0;
  std::size_t n_near_walls = 0;
  for (int trial = 0; trial < 80; ++trial) {
    SCOPED_TRACE(trial);
    const double bound = trial % 2 == 0 ? 0.05 : 0.4;
    const TwoSteps steps = two_steps(input, bound / 2.5, random);
    const PreparedMesh first(steps.first.soup);
    const PreparedMesh second(steps.second.soup);
    const DeviationMeter meter(input);
    ASSERT_TRUE(meter.find_far({steps.first, first, bound}).empty());
    const SurfaceStep step{steps.is_new, steps.gone};
    // In every second pair of trials most of what is gone is a wall.
    std::vector<InteriorWall> walls;
    for (std::size_t i = 0; trial % 4 >= 2 && i < steps.gone.size(); ++i) {
      if (i % 4 != 0) walls.push_back({steps.gone[i], kNoIndex});
    }
    const FarFaces whole = meter.find_far({steps.second, second, bound, walls});
    const FarFaces found = meter.find_far(
        {.tracked = steps.second, .mesh = second, .bound = bound, .walls = walls, .step = &step});
    EXPECT_EQ(found.of_input, whole.of_input);
    EXPECT_EQ(found.of_repaired, whole.of_repaired);
    n_far += whole.of_input.size() + whole.of_repaired.size();
    n_near_walls +=
        meter.find_far({steps.second, second, bound}).of_input.size() - whole.of_input.size();
  }
  EXPECT_GT(n_far, 80U);
  EXPECT_GT(n_near_walls, 40U);
}

/// Three faces above each other, at heights of 0, 0.3 and 9.
Soup three_faces() {
  return shapes::make({{0, 0, 0},
                       {1, 0, 0},
                       {0, 1, 0},
                       {0, 0, 0.3},
                       {1, 0, 0.3},
                       {0, 1, 0.3},
                       {0, 0, 9},
                       {1, 0, 9},
                       {0, 1, 9}},
                      {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}});
}

TEST(DeviationMeterStep, FaceThatOnlyANeighbourWasNearIsFarWithoutIt) {
  // The lowest face is gone, which the one in the middle is near to.
  const Soup input = three_faces();
  const TrackedMesh first = without_faces(track_mesh(input), {0});
  const TrackedMesh second = without_faces(track_mesh(input), {0, 1});
  const PreparedMesh mesh(second.soup);
  const std::vector<std::uint8_t> is_new{0};
  const std::vector<Corners> gone{corners_of(first.soup, 0)};
  const SurfaceStep step{is_new, gone};
  const FarFaces far = DeviationMeter(input).find_far(
      {.tracked = second, .mesh = mesh, .bound = 0.5, .walls = {}, .step = &step});
  EXPECT_EQ(far.of_input, (Faces{0, 1}));
}

TEST(DeviationMeterStep, FaceThatIsGoneIsNearToWhatIsLeftAndToWalls) {
  // The upper two faces are gone; the highest is a wall, a little moved.
  const Soup input = three_faces();
  const TrackedMesh second = without_faces(track_mesh(input), {1, 2});
  const PreparedMesh mesh(second.soup);
  const std::vector<InteriorWall> walls{{{Vec3(0, 0, 9.2), Vec3(1, 0, 9.2), Vec3(0, 1, 9.2)}, 2}};
  const SurfaceStep step{{0}, {corners_of(input, 1), corners_of(input, 2)}};
  const auto far_within = [&](double bound) {
    return DeviationMeter(input)
        .find_far({.tracked = second, .mesh = mesh, .bound = bound, .walls = walls, .step = &step})
        .of_input;
  };
  EXPECT_TRUE(far_within(0.35).empty());
  EXPECT_EQ(far_within(0.25), Faces{1});
  EXPECT_EQ(far_within(0.15), (Faces{1, 2}));
}

TEST(DeviationMeterStep, OfALargeFaceOnlyWhatIsNearIsMeasuredAgain) {
  // Each of two faces lies over 14,400 others, too many to measure in a whole. The others go up and
  // down by less than the bound.
  const double bound = 0.3;
  const Index n = 120;
  Soup fine = shapes::grid(n, n);
  for (Index v = 0; v < fine.n_vertices(); ++v) fine.positions[v].z() = v % 2 == 0 ? 0.0 : 0.2;
  TrackedMesh first = track_mesh(
      shapes::make(fine.positions, {{0, n, n * (n + 2)}, {0, n * (n + 2), n * (n + 1)}}));
  const Soup input = first.soup;
  first = without_faces(first, {0, 1});
  for (const Triangle& t : fine.triangles) add_face(first, t, 0);
  const PreparedMesh mesh(first.soup);
  const DeviationMeter meter(input);
  EXPECT_EQ(meter.find_far({first, mesh, bound}).of_input, (Faces{0, 1}));

  // The step removes the faces of two by two squares, whose middle is 1 away from the rim, and adds
  // them again or not.
  Faces removed;
  std::vector<Corners> gone;
  for (Index face = 0; face < fine.n_faces(); ++face) {
    const Corners t = corners_of(fine, face);
    const Vec3 middle = (t[0] + t[1] + t[2]) / 3 - Vec3(80, 30, 0);
    if (std::min(middle.x(), middle.y()) < 0 || std::max(middle.x(), middle.y()) > 2) continue;
    removed.push_back(face);
    gone.push_back(t);
  }
  ASSERT_EQ(removed.size(), 8U);
  const auto far_after = [&](const TrackedMesh& second) {
    std::vector<std::uint8_t> is_new(second.soup.n_faces(), 0);
    std::fill(is_new.begin() + fine.n_faces() - removed.size(), is_new.end(), 1);
    const SurfaceStep step{is_new, gone};
    return meter.find_far({.tracked = second,
                           .mesh = PreparedMesh(second.soup),
                           .bound = bound,
                           .walls = {},
                           .step = &step});
  };
  TrackedMesh second = without_faces(first, removed);
  EXPECT_EQ(far_after(second).of_input, Faces{0});
  for (const Index face : removed) add_face(second, fine.triangles[face], 0);
  EXPECT_TRUE(far_after(second).empty());
}

}  // namespace
}  // namespace meshalyzer
