#include "meshalyzer/repair/driver/internal/face_cover.h"

#include "meshalyzer/spatial/closest_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

const Corners kFace{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 3, 0}};

/// Cuts a triangle in three at a point.
std::vector<Corners> fan_at(const Corners& t, const Vec3& point) {
  return {{t[0], t[1], point}, {t[1], t[2], point}, {t[2], t[0], point}};
}

double distance_of(const std::vector<Corners>& parts, const Vec3& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Corners& part : parts) {
    nearest = std::min(nearest, closest_on_triangle(part, point).distance);
  }
  return nearest;
}

TEST(DistanceFromParts, PartsThatAreTheFaceAreAtNoDistance) {
  EXPECT_EQ(distance_from_parts(kFace, fan_at(kFace, {1, 1, 0})), 0.0);
}

TEST(DistanceFromParts, SideOfAPartDoesNotMatter) {
  std::vector<Corners> parts = fan_at(kFace, {1, 1, 0});
  std::swap(parts[1][0], parts[1][1]);
  EXPECT_EQ(distance_from_parts(kFace, parts), 0.0);
}

TEST(DistanceFromParts, MissingPartIsNoticed) {
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<Corners> parts = fan_at(kFace, {1, 1, 0});
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(distance_from_parts(kFace, parts)) << i;
  }
  EXPECT_FALSE(distance_from_parts(kFace, {}));
}

TEST(DistanceFromParts, OnePartTwiceIsNotTwoParts) {
  const std::vector<Corners> halves{{kFace[0], kFace[1], {2, 1.5, 0}},
                                    {kFace[0], {2, 1.5, 0}, kFace[2]}};
  EXPECT_EQ(distance_from_parts(kFace, halves), 0.0);
  EXPECT_FALSE(distance_from_parts(kFace, std::vector{halves[0], halves[0]}));
  EXPECT_FALSE(distance_from_parts(kFace, std::vector{halves[1], halves[1]}));
}

TEST(DistanceFromParts, FaceOfNoAreaIsNotKnownToBeCovered) {
  const Corners flat{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{1, 0, 0}};
  EXPECT_FALSE(distance_from_parts(flat, std::vector{flat}));
}

TEST(DistanceFromParts, IsABoundForPartsThatAreNearlyTheFace) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.05, 0.9);
  std::uniform_real_distribution<double> off(-1e-6, 1e-6);
  for (int run = 0; run < 50; ++run) {
    std::vector<Corners> parts{kFace};
    for (int cut = 0; cut < 10; ++cut) {
      const std::size_t which = random() % parts.size();
      const Corners t = parts[which];
      const double a = share(random);
      const double b = (1.0 - a) * share(random);
      const Vec3 inside = (1.0 - a - b) * t[0] + a * t[1] + b * t[2];
      const std::vector<Corners> fan =
          fan_at(t, inside + Vec3{off(random), off(random), off(random)});
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(which));
      parts.insert(parts.end(), fan.begin(), fan.end());
    }
    const auto bound = distance_from_parts(kFace, parts);
    ASSERT_TRUE(bound) << run;
    double largest = 0.0;
    for (int i = 0; i <= 30; ++i) {
      for (int k = 0; i + k <= 30; ++k) {
        const Vec3 point =
            kFace[0] + (kFace[1] - kFace[0]) * i / 30 + (kFace[2] - kFace[0]) * k / 30;
        largest = std::max(largest, distance_of(parts, point));
      }
    }
    EXPECT_LE(largest, *bound) << run;
    // Ten cuts are at most ten millionths off the plane; the farthest corner is 3.2 radii from the
    // incentre. incentre (1, 1): 3.2 radii.
    EXPECT_LE(*bound, 10 * 1e-6 * 4.2) << run;
  }
}

TEST(DistanceFromParts, PartsThatFitTogetherButNearlyNeedASlack) {
  // Each part has corners of its own for (1, 1, 0), and the edge from the origin to (4, 0, 0) is
  // split on one side of the thin parts along it alone.
  const double step = 1e-9;
  std::vector<Corners> parts = fan_at(kFace, {1, 1, 0});
  parts[1][2].x() += step;
  parts[2][2].y() -= step;
  const Vec3 middle{2, step, 0};
  const Vec3 left{1, -step, 0};
  parts.push_back({kFace[0], middle, left});
  parts.push_back({left, middle, kFace[1]});
  EXPECT_FALSE(distance_from_parts(kFace, parts));
  const auto bound = distance_from_parts(kFace, parts, 1e-7);
  ASSERT_TRUE(bound);
  // Corners move by sqrt(2) steps at most, edges by 5/3 (`middle` and the edge from `left` to
  // (4, 0, 0)), and parts are one step off the border; the farthest corner is 3.2 radii away.
  EXPECT_GT(*bound, step);
  EXPECT_LE(*bound, (std::sqrt(2.0) + 5.0 / 3.0 + 1.0) * step * 4.2);
  parts.erase(parts.begin());
  EXPECT_FALSE(distance_from_parts(kFace, parts, 1e-7));
}

TEST(DistanceFromParts, PartThatIsSmallerThanTheSlackCoversNothingElse) {
  constexpr double kSlack = 1e-7;
  const Vec3 centre{1, 1, 0};
  const Corners crumb{centre, centre + Vec3{kSlack / 4, 0, 0}, centre + Vec3{0, kSlack / 4, 0}};
  // Round the same point and long, but nowhere as wide as the slack.
  const Corners thread{Vec3{0, 1 - kSlack / 4, 0}, Vec3{2, 1, 0}, Vec3{1, 1 + kSlack / 4, 0}};
  EXPECT_FALSE(distance_from_parts(kFace, std::vector{crumb}, kSlack));
  EXPECT_FALSE(distance_from_parts(kFace, std::vector{thread}, kSlack));
  // Beside the other parts they are no obstacle.
  std::vector<Corners> parts = fan_at(kFace, centre);
  parts.push_back(crumb);
  const auto bound = distance_from_parts(kFace, parts, kSlack);
  ASSERT_TRUE(bound);
  EXPECT_LE(*bound, kSlack / 2 * 4.2);
}

}  // namespace
}  // namespace meshalyzer
