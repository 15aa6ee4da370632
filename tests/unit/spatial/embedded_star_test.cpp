#include "meshalyzer/spatial/embedded_star.h"

#include "meshalyzer/spatial/align_faces.h"
#include "meshalyzer/spatial/triangle_contact.h"
#include "support/random_soups.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

using Random = std::mt19937;

constexpr double kTurn = 2 * std::numbers::pi;

/// One vertex and those round it.
struct Ring {
  Vec3 hub = Vec3::Zero();
  std::vector<Vec3> link;
  bool is_closed = true;
};

bool is_proven(const Ring& ring) {
  std::vector<Arm> arms;
  for (const Vec3& p : ring.link) {
    arms.emplace_back(ring.hub, p);
  }
  return is_surely_embedded({.arms = arms, .is_closed = ring.is_closed});
}

/// Tells whether two faces share more than what they have in common, exactly.
bool meets_itself(const Ring& ring) {
  const std::size_t n = ring.link.size();
  const std::size_t n_faces = ring.is_closed ? n : n - 1;
  const auto point = [&](Index v) { return v == n ? ring.hub : ring.link[v]; };
  const auto face = [&](std::size_t i) {
    return Triangle{static_cast<Index>(n), static_cast<Index>(i), static_cast<Index>((i + 1) % n)};
  };
  for (std::size_t i = 0; i < n_faces; ++i) {
    for (std::size_t j = i + 1; j < n_faces; ++j) {
      const auto pair = align_faces(face(i), face(j), [](Index a, Index b) { return a == b; });
      const auto corners = [&](const Triangle& t) {
        return Corners{point(t[0]), point(t[1]), point(t[2])};
      };
      if (find_contact(corners(pair.p), corners(pair.q), static_cast<Common>(pair.n_common))) {
        return true;
      }
    }
  }
  return false;
}

/// A ring whose n points go round so many turns at a height of so much, turned anyhow in space.
Ring turning(std::size_t n, double turns, double height, Random& random) {
  const Eigen::AngleAxisd pose(
      uniform(random, 0, kTurn),
      Vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)).normalized());
  Ring ring;
  ring.is_closed = turns == std::round(turns);
  const std::size_t n_steps = ring.is_closed ? n : n - 1;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = kTurn * turns * static_cast<double>(i) / static_cast<double>(n_steps);
    const double radius = uniform(random, 0.5, 1);
    ring.link.emplace_back(
        pose * Vec3(radius * std::cos(angle), radius * std::sin(angle), radius * height));
  }
  return ring;
}

TEST(IsSurelyEmbedded, ProvesRingsThatGoRoundOnce) {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    const double height = uniform(random, -2, 2);
    EXPECT_TRUE(is_proven(turning(3 + random() % 20, 1, height, random)));
    EXPECT_TRUE(is_proven(turning(4 + random() % 20, uniform(random, 0.05, 0.49), height, random)));
  }
}

TEST(IsSurelyEmbedded, ProvesFlatRingsAlsoWhereTheirPlaneIsThatOfTwoAxes) {
  EXPECT_TRUE(is_proven({{0, 0, 0}, {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}}));
  EXPECT_TRUE(is_proven({{5, 5, 5}, {{5, 6, 5}, {5, 5, 6}, {5, 4, 5}, {5, 5, 4}}}));
}

TEST(IsSurelyEmbedded, ProvesTheCornerOfACubeAndASaddle) {
  EXPECT_TRUE(is_proven({{0, 0, 0}, {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}}));
  EXPECT_TRUE(is_proven({{0, 0, 0}, {{1, 0, .5}, {0, 1, -.5}, {-1, 0, .5}, {0, -1, -.5}}}));
}

TEST(IsSurelyEmbedded, ProvesTinyAndLargeRings) {
  for (const double size : {1e-70, 1e-30, 1e30, 1e69}) {
    EXPECT_TRUE(is_proven({{0, 0, 0}, {{size, 0, 0}, {0, size, 0}, {-size, -size, size}}}));
  }
}

TEST(IsSurelyEmbedded, SaysNothingBeyondWhatDoublesHold) {
  for (const double size : {1e-310, 1e-140, 1e100, 1e300, std::numeric_limits<double>::max()}) {
    EXPECT_FALSE(is_proven({{0, 0, 0}, {{size, 0, 0}, {0, size, 0}, {-size, -size, size}}}));
  }
}

TEST(IsSurelyEmbedded, DoesNotProveAConeThatWindsTwice) {
  Random random(2);
  for (int round = 0; round < 200; ++round) {
    // All of its faces face the axis of the cone, like those of one that winds once.
    EXPECT_FALSE(is_proven(turning(7 + random() % 20, 2, uniform(random, -2, 2), random)));
    EXPECT_FALSE(is_proven(turning(10 + random() % 20, 3, uniform(random, -2, 2), random)));
  }
}

TEST(IsSurelyEmbedded, ProvesNothingThatMeetsItselfHoweverOftenItWinds) {
  Random random(3);
  int n_proven = 0;
  int n_meeting = 0;
  for (int round = 0; round < 3000; ++round) {
    const double turns = uniform(random, 0.3, 3);
    const Ring ring = turning(4 + random() % 12, round % 4 == 0 ? std::ceil(turns) : turns,
                              uniform(random, -1, 1), random);
    const bool meets = meets_itself(ring);
    n_proven += static_cast<int>(is_proven(ring));
    n_meeting += static_cast<int>(meets);
    ASSERT_FALSE(meets && is_proven(ring)) << "round " << round;
  }
  EXPECT_GT(n_proven, 300);
  EXPECT_GT(n_meeting, 1000);
}

TEST(IsSurelyEmbedded, DoesNotProveAnOpenFanThatClosesOnItselfByPlace) {
  Random random(4);
  for (int round = 0; round < 300; ++round) {
    Ring ring = turning(3 + random() % 6, 1, uniform(random, -1, 1), random);
    ring.is_closed = false;
    ring.link.push_back(ring.link.front());
    EXPECT_TRUE(meets_itself(ring));
    EXPECT_FALSE(is_proven(ring));
  }
}

/// One step to the next double or the one before, or none.
double nudged(double x, Random& random) {
  const double infinity = std::numeric_limits<double>::infinity();
  switch (random() % 3) {
    case 0:
      return std::nextafter(x, infinity);
    case 1:
      return std::nextafter(x, -infinity);
    default:
      return x;
  }
}

Vec3 nudged(const Vec3& p, Random& random) {
  return {nudged(p.x(), random), nudged(p.y(), random), nudged(p.z(), random)};
}

/// Rings of points that `point` chooses, each moved to a double beside it or left, round a hub far
/// off or near: none that meets itself may be proven.
template <typename Point>
void expect_sound(Random& random, const Vec3& centre, Point point) {
  int n_proven = 0;
  for (int round = 0; round < 4000; ++round) {
    Ring ring;
    ring.hub = centre + nudged(point(), random);
    ring.is_closed = random() % 2 == 0;
    for (std::size_t n = 3 + random() % 4; n > 0; --n) {
      ring.link.push_back(nudged(centre + point(), random));
    }
    const bool is_so = is_proven(ring);
    n_proven += static_cast<int>(is_so);
    ASSERT_FALSE(is_so && meets_itself(ring)) << "round " << round;
  }
  EXPECT_GT(n_proven, 20);
}

TEST(IsSurelyEmbedded, IsSoundOneUlpFromTouching) {
  Random random(5);
  const auto whole = [&](int n) { return static_cast<double>(random() % n) - (n - 1) / 2; };
  expect_sound(random, Vec3::Zero(), [&] { return Vec3(whole(3), whole(3), whole(3)); });
  expect_sound(random, Vec3::Zero(), [&] { return Vec3(whole(5), whole(5), 0); });
  expect_sound(random, Vec3::Zero(), [&] {
    const double x = 0.1 * whole(5);
    const double y = 0.1 * whole(5);
    return Vec3(x, y, 0.3 * x + 0.7 * y);
  });
}

TEST(IsSurelyEmbedded, IsSoundWhereDifferencesAreRounded) {
  Random random(6);
  const auto whole = [&](int n) { return static_cast<double>(random() % n) - (n - 1) / 2; };
  const double step = 0x1p-22;
  expect_sound(random, {1e9, -1e9, 0.3},
               [&] { return Vec3(step * whole(5), step * whole(5), 0x1p-52 * whole(3)); });
  expect_sound(random, {1.0 / 3, 0, 0},
               [&] { return Vec3(0.1 * whole(3), 1e-17 * whole(5), 0.7 * whole(3)); });
}

TEST(IsSurelyEmbedded, SaysNothingOfZeroAreaAndOfNothing) {
  EXPECT_FALSE(is_proven({}));
  EXPECT_FALSE(is_proven({{0, 0, 0}, {{1, 0, 0}}, false}));
  EXPECT_FALSE(is_proven({{0, 0, 0}, {{1, 0, 0}, {2, 0, 0}, {0, 1, 0}}}));
  EXPECT_FALSE(is_proven({{0, 0, 0}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}));
}

}  // namespace
}  // namespace meshalyzer
