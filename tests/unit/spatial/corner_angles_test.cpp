#include "meshalyzer/spatial/corner_angles.h"

#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/align_faces.h"
#include "meshalyzer/spatial/triangle_contact.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>

namespace meshalyzer {
namespace {

using Random = std::mt19937;

/// Faces with one common corner and nothing else in common by id.
Soup crowd(std::size_t n_faces, const Vec3& hub, const std::function<Vec3()>& arm) {
  Soup soup;
  soup.positions.push_back(hub);
  for (Index i = 0; i < n_faces; ++i) {
    soup.positions.push_back(hub + arm());
    soup.positions.push_back(hub + arm());
    soup.triangles.push_back({0, 2 * i + 1, 2 * i + 2});
  }
  return soup;
}

std::size_t corner_at_hub(const Triangle& t) {
  return static_cast<std::size_t>(std::find(t.begin(), t.end(), Index{0}) - t.begin());
}

bool meet_beyond_hub(const FaceTree& tree, const Triangle& p, const Triangle& q) {
  const AlignedFaces<Index> pair = align_faces(p, q, [](Index a, Index b) { return a == b; });
  const auto corners = [&](const Triangle& t) {
    return Corners{tree.point(t[0]), tree.point(t[1]), tree.point(t[2])};
  };
  return find_contact(corners(pair.p), corners(pair.q), static_cast<Common>(pair.n_common))
      .has_value();
}

struct CornerTally {
  int n_apart = 0;
  int n_told = 0;
};

/// Asks for all pairs of a crowd: none that is told apart may share more than the hub.
CornerTally expect_sound_corners(const Soup& soup) {
  const CutMesh cut = build(soup);
  const FaceTree tree(cut);
  const CornerAngles angles(tree, {});
  EXPECT_FALSE(angles.empty());
  CornerTally tally;
  for (std::size_t a = 0; a < tree.n_faces(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const Triangle p = tree.triangle(a);
      const Triangle q = tree.triangle(b);
      const bool is_told = angles.are_apart(a, corner_at_hub(p), b, corner_at_hub(q));
      const bool meets = meet_beyond_hub(tree, p, q);
      EXPECT_FALSE(is_told && meets) << "slots " << a << " and " << b;
      tally.n_apart += static_cast<int>(!meets);
      tally.n_told += static_cast<int>(is_told);
    }
  }
  return tally;
}

TEST(AngleRange, RangeAroundTwoHoldsBothAndIsNoWiderThanNeeded) {
  Random random(7);
  for (int round = 0; round < 3000; ++round) {
    // Narrow ranges, wide ones, and some that go past a full turn.
    const auto any = [&] {
      return AngleRange{static_cast<std::uint32_t>(random()),
                        static_cast<std::uint32_t>(random() >> (random() % 32))};
    };
    const AngleRange a = any();
    const AngleRange b = any();
    const AngleRange both = AngleRange::around(a, b);
    for (const AngleRange& part : {a, b}) {
      const std::uint32_t from_begin = part.begin - both.begin;
      EXPECT_TRUE(both.width == ~std::uint32_t{0} ||
                  std::uint64_t{from_begin} + part.width <= both.width);
    }
    const AngleRange other_way = AngleRange::around(b, a);
    EXPECT_EQ(both.width, other_way.width);
    if (a.width < (1U << 20) && b.width < (1U << 20) && b.begin - a.begin < (1U << 30)) {
      EXPECT_LT(both.width, (1U << 30) + (1U << 20));
    }
  }
  constexpr std::uint32_t kTenth = ~std::uint32_t{0} / 10;
  EXPECT_EQ(AngleRange::around({0, kTenth}, {9 * kTenth, kTenth / 2}).begin, 9 * kTenth);
  EXPECT_EQ(AngleRange::around({kTenth, kTenth}, {0, 5 * kTenth}).width, 5 * kTenth);
}

TEST(AngleRange, RangesThatOnlyAdjoinOrWrapRoundAreToldRightly) {
  const AngleRange low{10, 20};
  EXPECT_TRUE(low.is_apart_from({31, 5}));
  EXPECT_FALSE(low.is_apart_from({30, 5}));
  EXPECT_FALSE(low.is_apart_from({0, 10}));
  EXPECT_TRUE(low.is_apart_from({0, 9}));
  // From a little below a full turn to 10 or 9 beyond it.
  const std::uint32_t below = 0U - 5U;
  EXPECT_FALSE(low.is_apart_from({below, 15}));
  EXPECT_TRUE(low.is_apart_from({below, 14}));
  EXPECT_FALSE(low.is_apart_from(AngleRange()));
  EXPECT_FALSE(AngleRange().is_apart_from(AngleRange()));
}

TEST(CornerAngles, NarrowCornersOfAFlatCrowdAreToldApartIfTheyAre) {
  Random random(3);
  double turn = 0.0;
  bool is_first = true;
  const auto arm = [&] {
    turn = is_first ? uniform(random, 0, 2 * std::numbers::pi) : turn + 0.02;
    is_first = !is_first;
    return Vec3(std::cos(turn), std::sin(turn), uniform(random, -0.1, 0.1));
  };
  const CornerTally tally = expect_sound_corners(crowd(120, {0, 0, 0}, arm));
  // Two ranges of 0.02 overlap for 0.04 in 2 pi of pairs, and some that do so are apart in height.
  EXPECT_GT(tally.n_apart, 7000);
  EXPECT_GT(tally.n_told, tally.n_apart * 98 / 100);
}

TEST(CornerAngles, CornersInAllDirectionsAreNotToldApartIfTheyMeet) {
  Random random(5);
  const auto arm = [&] {
    return Vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
  };
  const CornerTally tally = expect_sound_corners(crowd(150, {0.1, 0.2, 0.3}, arm));
  EXPECT_GT(tally.n_told, 0);
}

TEST(CornerAngles, CornersThatMeetByOneRoundingAreNotToldApart) {
  // Each second corner begins in the direction in which the one before it ends, but for a few units
  // in the last place either way.
  Random random(7);
  Vec3 last(1, 0, 0);
  bool is_first = true;
  const auto arm = [&] {
    if (is_first) {
      const double length = uniform(random, 0.5, 2.0);
      last = length * last * (1 + uniform(random, -4, 4) * 0x1p-52);
      last.y() += uniform(random, -2, 2) * 0x1p-53;
    } else {
      const double turn = std::atan2(last.y(), last.x()) + 0.05;
      last = Vec3(std::cos(turn), std::sin(turn), 0.0);
    }
    is_first = !is_first;
    return last;
  };
  expect_sound_corners(crowd(120, {0, 0, 0}, arm));
}

TEST(CornerAngles, CornersOfTinyAndHugeCrowdsAreNotToldApartIfTheyMeet) {
  for (const double scale : {1e-306, 1e-200, 1e200, 1e306}) {
    Random random(11);
    const auto arm = [&] {
      return Vec3(scale * uniform(random, -1, 1), scale * uniform(random, -1, 1),
                  scale * uniform(random, -0.1, 0.1));
    };
    SCOPED_TRACE(scale);
    expect_sound_corners(crowd(60, {0, 0, 0}, arm));
  }
}

TEST(CornerAngles, FacesWithTwoCornersAtOnePlaceAreNotToldApart) {
  Soup soup = crowd(40, {0, 0, 0}, [turn = 0.0]() mutable {
    turn += 0.1;
    return Vec3(std::cos(turn), std::sin(turn), 0.0);
  });
  soup.positions[2] = soup.positions[0];
  const CutMesh cut = build(soup);
  const FaceTree tree(cut);
  const CornerAngles angles(tree, {});
  ASSERT_FALSE(angles.empty());
  for (std::size_t a = 0; a < tree.n_faces(); ++a) {
    for (std::size_t b = 0; b < tree.n_faces(); ++b) {
      if (tree.mesh_face(a) != 0 || a == b) continue;
      EXPECT_FALSE(
          angles.are_apart(a, corner_at_hub(tree.triangle(a)), b, corner_at_hub(tree.triangle(b))));
    }
  }
}

TEST(CornerAngles, OrdinaryMeshAndProvenCrowdHoldNothing) {
  const CutMesh sphere = build(shapes::uv_sphere(20, 20));
  EXPECT_TRUE(CornerAngles(FaceTree(sphere), std::vector<std::uint8_t>(400, 1)).empty());
  const CutMesh torus = build(shapes::torus(2, 0.5, 30, 20));
  EXPECT_TRUE(CornerAngles(FaceTree(torus), {}).empty());
}

}  // namespace
}  // namespace meshalyzer
