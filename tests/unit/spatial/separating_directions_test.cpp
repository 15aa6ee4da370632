#include "meshalyzer/spatial/separating_directions.h"

#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/triangle_contact.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <random>

namespace meshalyzer {
namespace {

using Random = std::mt19937;

/// Faces without common vertices, and two far corners that give the tree its scale.
Soup strangers(std::size_t n_faces, const std::function<Vec3()>& point) {
  Soup soup;
  for (Index i = 0; i < n_faces; ++i) {
    for (int c = 0; c < 3; ++c) {
      soup.positions.push_back(point());
    }
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return soup;
}

Corners corners_of(const FaceTree& tree, std::size_t slot) {
  const Triangle t = tree.triangle(slot);
  return {tree.point(t[0]), tree.point(t[1]), tree.point(t[2])};
}

struct DirectionTally {
  int n_apart = 0;
  int n_told = 0;
};

/// Asks for all pairs of a mesh: none that is told apart may have a contact.
DirectionTally expect_sound_directions(const Soup& soup) {
  const CutMesh cut = build(soup);
  const FaceTree tree(cut);
  DirectionTally tally;
  for (std::size_t a = 0; a < tree.n_faces(); ++a) {
    const SeparatingDirections directions(LeafTriangles(tree, a / 8), a % 8);
    for (std::size_t leaf = 0; leaf < tree.n_leaves(); ++leaf) {
      const unsigned left = directions.perhaps_meeting(LeafTriangles(tree, leaf), 0xFFU);
      for (std::size_t b = 8 * leaf; b < std::min(8 * leaf + 8, tree.n_faces()); ++b) {
        const bool is_told = ((left >> (b % 8)) & 1U) == 0;
        const bool meets =
            find_contact(corners_of(tree, a), corners_of(tree, b), Common::Nothing).has_value();
        EXPECT_FALSE(is_told && meets) << "slots " << a << " and " << b;
        tally.n_apart += static_cast<int>(!meets);
        tally.n_told += static_cast<int>(is_told);
      }
    }
  }
  return tally;
}

TEST(SeparatingDirections, TellNearlyAllFacesApartThatAre) {
  Random random(1);
  const auto point = [&] {
    return Vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
  };
  const DirectionTally tally = expect_sound_directions(strangers(160, point));
  EXPECT_GT(tally.n_told, tally.n_apart / 2);
}

TEST(SeparatingDirections, TellParallelSliversApart) {
  // Long faces side by side in one plane, askew to the axes, a hundredth apart.
  int i = 0;
  const auto point = [&] {
    const double across = 0.01 * (i / 3) + (i % 3 == 2 ? 0.005 : 0.0);
    const Vec3 p = Vec3(1, 1.1, 0.9) * (i % 3 == 1 ? 10.0 : 0.0) + Vec3(1, -1, 0.1) * across;
    ++i;
    return p;
  };
  const DirectionTally tally = expect_sound_directions(strangers(64, point));
  EXPECT_EQ(tally.n_apart, 64 * 63);
  EXPECT_EQ(tally.n_told, tally.n_apart);
}

TEST(SeparatingDirections, AreSoundWhereFacesTouch) {
  Random random(2);
  const auto lattice = [&] { return static_cast<double>(random() % 4); };
  EXPECT_GT(
      expect_sound_directions(strangers(120, [&] { return Vec3(lattice(), lattice(), 0); })).n_told,
      0);
  EXPECT_GT(
      expect_sound_directions(strangers(120, [&] { return Vec3(lattice(), lattice(), lattice()); }))
          .n_told,
      0);
}

TEST(SeparatingDirections, AreSoundWhereFacesAreApartByAboutTheRoundingOfSinglePrecision) {
  Random random(3);
  for (const double gap : {0x1p-26, 0x1p-24, 0x1p-22, 0x1p-20, 0x1p-18}) {
    for (const double far : {0.0, 1.0 / 3, 1e6}) {
      // On both sides of one plane, by a few times the gap or less.
      const auto point = [&] {
        const double x = uniform(random, 0, 1);
        const double y = uniform(random, 0, 1);
        return Vec3(x + far, y, 0.3 * x + 0.7 * y + gap * uniform(random, -2, 2));
      };
      expect_sound_directions(strangers(64, point));
    }
  }
}

TEST(SeparatingDirections, AreSoundForTinyFacesInALargeMesh) {
  Random random(4);
  for (const double size : {1e-6, 1e-7, 1e-12, 1e-25}) {
    Soup soup = strangers(60, [&] {
      return Vec3(size * uniform(random, -1, 1), size * uniform(random, -1, 1),
                  size * uniform(random, -1, 1));
    });
    soup = shapes::merged(soup, shapes::cube(2.0, {-1, -1, -1}));
    expect_sound_directions(soup);
  }
}

TEST(SeparatingDirections, AreSoundForFacesOfZeroArea) {
  Random random(5);
  const auto on_a_line = [&] { return Vec3(static_cast<double>(random() % 9) * Vec3(1, 2, 3)); };
  EXPECT_GE(expect_sound_directions(strangers(60, on_a_line)).n_told, 0);
}

TEST(SeparatingDirections, AskOnlyForTheLanesGiven) {
  const CutMesh cut = build(strangers(2, [i = 0]() mutable {
    ++i;
    return Vec3(i % 3 == 0, i % 3 == 1, i > 3 ? 5 : 0);
  }));
  const FaceTree tree(cut);
  const LeafTriangles faces(tree, 0);
  const SeparatingDirections directions(faces, 0);
  EXPECT_EQ(directions.perhaps_meeting(faces, 0b01U), 0b01U) << "the face itself";
  EXPECT_EQ(directions.perhaps_meeting(faces, 0b10U), 0U);
  EXPECT_EQ(directions.perhaps_meeting(faces, 0U), 0U);
}

}  // namespace
}  // namespace meshalyzer
