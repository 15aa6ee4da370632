#include "meshalyzer/repair/split/internal/tip_lid.h"

#include "meshalyzer/base/corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

const Vec3 kOrigin = Vec3::Zero();

/// The ends of two ridges and, between them, of two valleys.
const std::vector<Vec3> kSaddle{{1, 0, 0.5}, {0, 1, -0.5}, {-1, 0, 0.5}, {0, -1, -0.5}};

bool has_edge(const std::vector<Triangle>& lid, Index a, Index b) {
  return std::any_of(lid.begin(), lid.end(), [&](const Triangle& t) {
    return std::find(t.begin(), t.end(), a) != t.end() &&
           std::find(t.begin(), t.end(), b) != t.end();
  });
}

/// Counts how often triangles have each half-edge less how often they have its opposite.
std::map<std::pair<Index, Index>, int> border_of(const std::vector<Triangle>& triangles) {
  std::map<std::pair<Index, Index>, int> border;
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::pair edge{t[i], t[(i + 1) % 3]};
      const std::pair opposite{edge.second, edge.first};
      if (border[opposite] > 0) {
        --border[opposite];
      } else {
        ++border[edge];
      }
    }
  }
  std::erase_if(border, [](const auto& entry) { return entry.second == 0; });
  return border;
}

/// Tells by rounded arithmetic whether a ray from the origin meets a triangle.
bool meets(const Vec3& ray, const Corners& t) {
  Eigen::Matrix3d corners;
  corners << t[0], t[1], t[2];
  return (corners.inverse() * ray).minCoeff() > 0.0;
}

TEST(CloseTip, ThreePointsAreOneTriangle) {
  const std::vector<Vec3> ring{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto lid = close_tip(kOrigin, ring, {});
  ASSERT_TRUE(lid);
  EXPECT_EQ(border_of(*lid), border_of({{0, 1, 2}}));
}

TEST(CloseTip, LiesOnTheSideWhereNothingElseIs) {
  const std::vector<Vec3> above{{0, 0, 1}};
  const auto below_others = close_tip(kOrigin, kSaddle, above);
  ASSERT_TRUE(below_others);
  EXPECT_TRUE(has_edge(*below_others, 1, 3));
  const std::vector<Vec3> below{{0, 0, -1}};
  const auto above_others = close_tip(kOrigin, kSaddle, below);
  ASSERT_TRUE(above_others);
  EXPECT_TRUE(has_edge(*above_others, 0, 2));
  EXPECT_FALSE(close_tip(kOrigin, kSaddle, std::vector<Vec3>{{0, 0, 1}, {0, 0, -1}}));
}

TEST(CloseTip, RingsOnOnePlaneWithTheApexHaveNoLid) {
  const std::vector<Vec3> ring{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  EXPECT_FALSE(close_tip(kOrigin, ring, {}));
}

/// Rings round the axis z, as ragged as the surfaces that rounding leaves, with narrow cones of
/// other surfaces above and below them.
TEST(CloseTip, LidsOfRaggedRingsHaveTheirBorderAndMeetNoOtherSurface) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  std::size_t n_lids = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const int n = 3 + trial % 12;
    std::vector<Vec3> ring;
    for (int i = 0; i < n; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + 0.4 * part(random)) / n;
      const Vec3 direction(std::cos(angle), std::sin(angle), part(random));
      ring.emplace_back((1.5 + part(random)) * direction);
    }
    std::vector<Vec3> others;
    for (int i = 0; i < 5; ++i) {
      others.emplace_back(0.1 * part(random), 0.1 * part(random), trial % 2 == 0 ? 1.0 : -1.0);
    }
    const auto lid = close_tip(kOrigin, ring, others);
    if (!lid) continue;
    ++n_lids;
    ASSERT_EQ(lid->size(), ring.size() - 2);
    std::map<std::pair<Index, Index>, int> border;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto next = static_cast<Index>((i + 1) % ring.size());
      border[{static_cast<Index>(i), next}] = 1;
    }
    EXPECT_EQ(border_of(*lid), border);
    for (const Triangle& t : *lid) {
      for (const Vec3& other : others) {
        EXPECT_FALSE(meets(other, corners_of(ring, t))) << trial;
      }
    }
    // A ray meets each place of the lid once: no two triangles overlap.
    for (int i = 0; i < 50; ++i) {
      const Vec3 ray(part(random), part(random), part(random));
      EXPECT_LE(std::count_if(lid->begin(), lid->end(),
                              [&](const Triangle& t) { return meets(ray, corners_of(ring, t)); }),
                1)
          << trial;
    }
  }
  // Most rings have a side that can be closed without further points.
  EXPECT_GT(n_lids, 100U);
}

}  // namespace
}  // namespace meshalyzer
