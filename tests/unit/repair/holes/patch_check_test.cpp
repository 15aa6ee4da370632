#include "meshalyzer/repair/holes/internal/patch_check.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

constexpr Index kCorners = 12;

/// A bowl: the flanks of a pyramid whose base, a ring of twelve vertices near z = 1, is open. The
/// vertex at its bottom is the last.
Soup bowl() {
  Soup soup = shapes::make({}, {});
  for (Index i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    soup.positions.emplace_back(std::cos(angle), std::sin(angle), 1.0 + 0.1 * (i % 3));
  }
  soup.positions.emplace_back(0, 0, 0);
  for (Index i = 0; i < kCorners; ++i) {
    soup.triangles.push_back({kCorners, (i + 1) % kCorners, i});
  }
  return shapes::make(std::move(soup.positions), std::move(soup.triangles));
}

/// A fan round an added vertex over the opening.
Patch lid(const Vec3& middle) {
  Patch patch{.triangles = {}, .added = {middle}};
  for (Index i = 0; i < kCorners; ++i) {
    patch.triangles.push_back({i, (i + 1) % kCorners, kCorners + 1});
  }
  return patch;
}

TEST(IsSound, PatchesWithAndWithoutFaultsAreTold) {
  const Soup soup = bowl();
  const PreparedMesh mesh(soup);
  EXPECT_TRUE(is_sound(mesh, lid({0, 0, 1.2})));
  // Through the bowl.
  EXPECT_FALSE(is_sound(mesh, lid({1.5, 0, 0})));
  // Through itself.
  Patch crossed = lid({0, 0, 1.5});
  std::swap(crossed.triangles[2][0], crossed.triangles[6][0]);
  EXPECT_FALSE(is_sound(mesh, crossed));
  // Torn: two faces have an edge the same way round.
  Patch torn = lid({0, 0, 1.2});
  std::swap(torn.triangles[0][0], torn.triangles[0][1]);
  EXPECT_FALSE(is_sound(mesh, torn));
}

TEST(IsSound, AnswerIsThatOfTheWholeCheck) {
  const Soup soup = bowl();
  const PreparedMesh mesh(soup);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-1.5, 1.5);
  int n_sound = 0;
  for (int i = 0; i < 300; ++i) {
    const Patch patch = lid({any(random), any(random), any(random)});
    EXPECT_EQ(is_sound(mesh, patch), check_patch(mesh, patch).empty());
    n_sound += is_sound(mesh, patch) ? 1 : 0;
  }
  EXPECT_GT(n_sound, 20);
  EXPECT_LT(n_sound, 280);
}

}  // namespace
}  // namespace meshalyzer
