#include "meshalyzer/arrangement/remove_slivers.h"

#include "meshalyzer/base/triangle.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

RoundedFaces rounded_faces(const Soup& soup) {
  RoundedFaces faces{.positions = soup.positions,
                     .triangles = soup.triangles,
                     .ages = std::vector(soup.n_faces(), FaceAge::New),
                     .origins = std::vector<Index>(soup.n_faces())};
  std::iota(faces.origins.begin(), faces.origins.end(), Index{0});
  return faces;
}

/// Tells whether faces cross every edge equally often in both directions.
bool is_balanced(const RoundedFaces& faces) {
  std::map<std::array<Index, 2>, int> balance;
  for (const Triangle& t : faces.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = t[k];
      const Index b = t[(k + 1) % 3];
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  return std::all_of(balance.begin(), balance.end(),
                     [](const auto& entry) { return entry.second == 0; });
}

double six_volumes(const RoundedFaces& faces) {
  double sum = 0.0;
  for (const auto& [a, b, c] : faces.triangles) {
    sum += faces.positions[a].dot(faces.positions[b].cross(faces.positions[c]));
  }
  return sum;
}

double least_altitude(const RoundedFaces& faces) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : faces.triangles) {
    const Corners corners{faces.positions[a], faces.positions[b], faces.positions[c]};
    least = std::min(least, normal_of(corners).norm() / longest_side(corners));
  }
  return least;
}

TEST(RoundedFaceEdits, ClosedSurfaceStaysClosedWhateverIsDone) {
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) {
    RoundedFaces faces = rounded_faces(shapes::icosphere(1));
    // In general position no face is flat, so that none is left out in the end.
    std::uniform_real_distribution<double> noise(-0.1, 0.1);
    for (Vec3& p : faces.positions) p += Vec3(noise(random), noise(random), noise(random));
    RoundedFaceEdits edits(faces);
    for (int k = 0; k < 30; ++k) {
      const auto face = static_cast<Index>(random() % faces.triangles.size());
      const auto v = static_cast<Index>(random() % faces.positions.size());
      if (edits.is_removed(face)) continue;
      const auto [a, b, c] = faces.triangles[face];
      if (random() % 2 == 0 && a != v) edits.collapse(a, v);
      if (random() % 2 == 0 && a != v && b != v) edits.split_edge(a, b, v);
    }
    edits.finish();
    EXPECT_TRUE(is_balanced(faces));
    EXPECT_EQ(faces.triangles.size(), faces.ages.size());
    EXPECT_EQ(faces.triangles.size(), faces.origins.size());
  }
}

TEST(RoundedFaceEdits, NewFacesWithoutAreaAreLeftOutInTheEnd) {
  const Soup soup =
      shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 1, 3}, {1, 3, 0}});
  RoundedFaces faces = rounded_faces(soup);
  faces.ages[2] = FaceAge::Old;
  RoundedFaceEdits(faces).finish();
  EXPECT_EQ(faces.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 3, 0}}));
  EXPECT_EQ(faces.origins, (std::vector<Index>{0, 2}));
}

TEST(RemoveSlivers, ThinFacesGoAndTheVolumeStays) {
  // A tetrahedron with a vertex just beside the middle of an edge: a face has an altitude of 1e-6.
  const Soup soup =
      shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 1e-6, 0}},
                   {{0, 2, 1}, {0, 1, 4}, {0, 4, 3}, {4, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  RoundedFaces faces = rounded_faces(soup);
  ASSERT_TRUE(is_balanced(faces));
  ASSERT_LT(least_altitude(faces), 1.1e-6);
  remove_slivers(faces, 1e-7);
  EXPECT_EQ(faces.triangles, soup.triangles);
  remove_slivers(faces, 1e-5);
  EXPECT_TRUE(is_balanced(faces));
  EXPECT_EQ(faces.triangles.size(), 6U);
  EXPECT_NEAR(six_volumes(faces), 1.0, 1e-5);
  EXPECT_GT(least_altitude(faces), 0.1);
}

TEST(RemoveSlivers, OnlyFacesThatItMakesAreNewThen) {
  Soup soup = shapes::icosphere(2);
  const auto [low, high] = std::minmax(soup.triangles.front()[0], soup.triangles.front()[1]);
  soup.positions[high] = soup.positions[low] + Vec3(1e-9, 0, 0);
  RoundedFaces faces = rounded_faces(soup);
  std::fill(faces.ages.begin(), faces.ages.end(), FaceAge::Searched);
  remove_slivers(faces, 1e-6);
  std::size_t n_new = 0;
  for (Index face = 0; face < faces.triangles.size(); ++face) {
    const bool is_changed = faces.triangles[face] != soup.triangles[faces.origins[face]];
    EXPECT_EQ(faces.ages[face], is_changed ? FaceAge::New : FaceAge::Searched) << face;
    n_new += is_changed ? 1 : 0;
  }
  // The vertex had six faces, of which two went with the edge.
  EXPECT_EQ(n_new, 4U);
}

TEST(RemoveSlivers, ShortEdgesAreCollapsedToTheLowerVertex) {
  Soup soup = shapes::icosphere(1);
  const auto [low, high] = std::minmax(soup.triangles.front()[0], soup.triangles.front()[1]);
  soup.positions[high] = soup.positions[low] + Vec3(1e-9, 0, 0);
  RoundedFaces faces = rounded_faces(soup);
  remove_slivers(faces, 1e-6);
  EXPECT_EQ(faces.triangles.size(), soup.n_faces() - 2);
  EXPECT_TRUE(is_balanced(faces));
  for (const Triangle& t : faces.triangles) EXPECT_EQ(std::count(t.begin(), t.end(), high), 0);
}

TEST(RemoveSlivers, FacesThatAreNotNewStay) {
  const Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}}, {{0, 1, 2}});
  RoundedFaces faces = rounded_faces(soup);
  faces.ages.front() = FaceAge::Old;
  remove_slivers(faces, 1e-3);
  EXPECT_EQ(faces.triangles, soup.triangles);
}

TEST(RemoveSlivers, ManyAtOneEdgeEndInBoundedWork) {
  // Round one edge are thin triangles, whose corners are nearly on it, and large ones, which each
  // thin one divides.
  constexpr Index kOfEach = 200;
  Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}}, {});
  for (Index i = 0; i < kOfEach; ++i) {
    const double angle = i;
    for (const double distance : {1e-7, 1.0}) {
      soup.positions.emplace_back((i + 1.0) / (kOfEach + 1), distance * std::cos(angle),
                                  distance * std::sin(angle));
      soup.triangles.push_back({0, 1, static_cast<Index>(soup.n_vertices() - 1)});
    }
  }
  RoundedFaces faces = rounded_faces(soup);
  remove_slivers(faces, 1e-6);
  EXPECT_LE(faces.triangles.size(), 2 * soup.n_faces());
  for (const Index origin : faces.origins) EXPECT_LT(origin, soup.n_faces());
}

}  // namespace
}  // namespace meshalyzer
