#include "meshalyzer/spatial/leaf_frame.h"

#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/triangle_contact.h"
#include "support/random_soups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace meshalyzer {
namespace {

using Random = std::mt19937;

/// Two directions across (1, 1, 1).
constexpr std::array<std::array<float, 3>, 2> kAcross{
    {{0.70710678F, -0.70710678F, 0.0F}, {0.40824829F, 0.40824829F, -0.81649658F}}};

/// Faces without common vertices, the third corner of each near one of the others.
Soup slivers(std::size_t n_faces, const std::function<Vec3()>& place) {
  Soup soup;
  for (Index i = 0; i < n_faces; ++i) {
    const Vec3 from = place();
    const Vec3 along = Vec3(0.5, 0.5, 0.5);
    soup.positions.insert(soup.positions.end(), {from - along, from + along, place() - along});
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return soup;
}

bool meet(const FaceTree& tree, std::size_t a, std::size_t b) {
  const auto corners_of = [&](std::size_t slot) {
    const Triangle t = tree.triangle(slot);
    return Corners{tree.point(t[0]), tree.point(t[1]), tree.point(t[2])};
  };
  return find_contact(corners_of(a), corners_of(b), Common::Nothing).has_value();
}

/// Asks for all pairs of a mesh of whole leaves: none that is dropped may have a contact.
///
/// @return  How many of them are dropped.
int expect_sound_frames(const Soup& soup) {
  const CutMesh cut = build(soup);
  const FaceTree tree(cut);
  int n_dropped = 0;
  for (std::size_t leaf = 0; leaf < tree.n_leaves(); ++leaf) {
    const LeafFrame frame(LeafTriangles(tree, leaf), kAcross);
    for (std::size_t other = 0; other < tree.n_leaves(); ++other) {
      LeafFrame::Partners partners;
      partners.fill(0xFFU);
      frame.drop_apart(LeafTriangles(tree, other), partners);
      for (std::size_t pair = 0; pair < 64; ++pair) {
        if ((partners[pair / 8] >> (pair % 8) & 1U) != 0) continue;
        ++n_dropped;
        EXPECT_FALSE(meet(tree, 8 * leaf + pair / 8, 8 * other + pair % 8));
      }
    }
  }
  return n_dropped;
}

TEST(LeafFrame, DropsFacesThatRunSideBySide) {
  // A hundredth apart along the first direction, each a two-hundredth wide.
  int i = 0;
  const auto place = [&] { return Vec3(0.005 * i++ * Vec3(0.7, -0.7, 0)); };
  EXPECT_EQ(expect_sound_frames(slivers(64, place)), 64 * 63);
}

TEST(LeafFrame, KeepsFacesThatTouch) {
  Random random(2);
  const auto lattice = [&] {
    return Vec3(static_cast<double>(random() % 8) / 8, static_cast<double>(random() % 8) / 8, 0);
  };
  EXPECT_GT(expect_sound_frames(slivers(64, lattice)), 0);
}

TEST(LeafFrame, IsSoundWhereFacesAreApartByAboutTheRoundingOfSinglePrecision) {
  Random random(3);
  for (const double gap : {0x1p-26, 0x1p-24, 0x1p-22, 0x1p-20}) {
    for (const double far : {0.0, 1.0 / 3, 1e6}) {
      const auto place = [&] {
        return Vec3(Vec3(far, 0, far) +
                    gap * Vec3(uniform(random, -2, 2), uniform(random, -2, 2), 0));
      };
      expect_sound_frames(slivers(64, place));
    }
  }
}

TEST(LeafFrame, AddsNoPartners) {
  const CutMesh cut = build(slivers(8, [i = 0]() mutable { return Vec3(i++, 0, 0); }));
  const FaceTree tree(cut);
  const LeafTriangles faces(tree, 0);
  LeafFrame::Partners partners{0b1U, 0b11U, 0U, 0b10000001U};
  const LeafFrame::Partners before = partners;
  LeafFrame(faces, kAcross).drop_apart(faces, partners);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(partners[i] & ~before[i], 0U);
}

}  // namespace
}  // namespace meshalyzer
