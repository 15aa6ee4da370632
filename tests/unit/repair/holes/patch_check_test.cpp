#include "meshalyzer/repair/holes/internal/patch_check.h"

#include "meshalyzer/repair/rules/internal/contact_rule.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
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

/// By comparison of all faces with all others: tells for each face of a patch whether it is in
/// contact with the mesh or another face of the patch.
std::vector<Index> contacts_by_brute_force(const Soup& soup, const Patch& patch) {
  const auto of_patch = [&](const Triangle& t) {
    return PlacedFace{t, corners_of(soup, patch, t)};
  };
  std::vector<Index> meeting;
  for (Index i = 0; i < patch.triangles.size(); ++i) {
    const PlacedFace face = of_patch(patch.triangles[i]);
    const bool meets_mesh =
        std::any_of(soup.triangles.begin(), soup.triangles.end(), [&](const Triangle& t) {
          return are_in_contact_beyond_copies(face, {t, corners_of(soup, {}, t)});
        });
    const bool meets_patch =
        std::any_of(patch.triangles.begin(), patch.triangles.end(), [&](const Triangle& t) {
          return t != patch.triangles[i] && are_in_contact_beyond_copies(face, of_patch(t));
        });
    if (meets_mesh || meets_patch) meeting.push_back(i);
  }
  return meeting;
}

TEST(IsSound, AnswerIsThatOfBruteForce) {
  const Soup soup = bowl();
  const PreparedMesh mesh(soup);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-1.5, 1.5);
  int n_sound = 0;
  for (int i = 0; i < 300; ++i) {
    const Patch patch = lid({any(random), any(random), any(random)});
    EXPECT_EQ(is_sound(mesh, patch), contacts_by_brute_force(soup, patch).empty());
    n_sound += is_sound(mesh, patch) ? 1 : 0;
  }
  EXPECT_GT(n_sound, 20);
  EXPECT_LT(n_sound, 280);
}

/// Cuts the ears of the opening off in random order.
Patch random_triangulation(std::mt19937& random) {
  std::vector<Index> rest(kCorners);
  std::iota(rest.begin(), rest.end(), Index{0});
  Patch patch;
  while (rest.size() > 2) {
    const std::size_t ear = random() % rest.size();
    const std::size_t before = (ear + rest.size() - 1) % rest.size();
    const std::size_t after = (ear + 1) % rest.size();
    patch.triangles.push_back({rest[before], rest[ear], rest[after]});
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return patch;
}

TEST(TriangulationChecker, FaultsAreThoseOfBruteForceWhateverWasCheckedBefore) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> height(0.2, 1.5);
  int n_sound = 0;
  int n_faulty = 0;
  for (int i = 0; i < 20; ++i) {
    Soup soup = bowl();
    for (Index v = 0; v < kCorners; ++v) soup.positions[v].z() = height(random);
    const PreparedMesh mesh(soup);
    TriangulationChecker checker(mesh);
    for (int k = 0; k < 30; ++k) {
      const Patch patch = random_triangulation(random);
      const PatchFaults faults = checker.check(patch);
      EXPECT_FALSE(faults.is_torn);
      EXPECT_EQ(faults.meeting, contacts_by_brute_force(soup, patch));
      (faults.empty() ? n_sound : n_faulty) += 1;
    }
  }
  EXPECT_GT(n_sound, 20);
  EXPECT_GT(n_faulty, 20);
}

TEST(FacesMet, AreThoseOfBruteForce) {
  const Soup soup = bowl();
  const PreparedMesh mesh(soup);
  const Patch patch = lid({1.5, 0, 0});
  std::vector<Index> expected;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const PlacedFace face{soup.triangles[f], corners_of(soup, {}, soup.triangles[f])};
    const bool is_met =
        std::any_of(patch.triangles.begin(), patch.triangles.end(), [&](const Triangle& t) {
          return are_in_contact_beyond_copies(face, {t, corners_of(soup, patch, t)});
        });
    if (is_met) expected.push_back(f);
  }
  EXPECT_GT(expected.size(), 1U);
  EXPECT_EQ(faces_met(mesh, patch), expected);
}

}  // namespace
}  // namespace meshalyzer
