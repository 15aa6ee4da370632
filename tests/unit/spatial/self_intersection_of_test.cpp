#include "meshalyzer/spatial/self_intersection_of.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/self_intersection.h"
#include "support/random_soups.h"
#include "support/shapes.h"
#include "support/sliver_tube.h"
#include "unit/spatial/pairs_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>
#include <utility>

namespace meshalyzer {
namespace {

using Random = std::mt19937;
using Faces = std::vector<Index>;

/// About one of so many faces, ascending.
Faces some_of(const Soup& soup, Index rarity, Random& random) {
  Faces faces;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    if (below(random, rarity) == 0) faces.push_back(f);
  }
  return faces;
}

Faces all_of(const Soup& soup) {
  Faces faces(soup.n_faces());
  std::iota(faces.begin(), faces.end(), Index{0});
  return faces;
}

/// Returns the pairs of the whole mesh that have one of the faces.
Pairs filtered(const Pairs& pairs, const Faces& faces) {
  const auto is_given = [&](Index f) { return std::binary_search(faces.begin(), faces.end(), f); };
  Pairs kept;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(kept),
               [&](const IntersectingPair& p) { return is_given(p.face_a) || is_given(p.face_b); });
  return kept;
}

/// Asks for few, many, all and single faces of a mesh. Gives the number of its pairs.
std::size_t expect_filtered(const Soup& soup, Random& random) {
  const CutMesh cut = build(soup);
  const FaceTree tree(cut);
  const Pairs all = find_self_intersections(cut, tree);
  std::vector<Faces> questions{{}, all_of(soup)};
  for (const Index rarity : {2U, 3U, 10U, 50U}) {
    questions.push_back(some_of(soup, rarity, random));
  }
  for (int i = 0; i < 10; ++i) {
    questions.push_back({below(random, static_cast<Index>(soup.n_faces()))});
  }
  for (const Faces& faces : questions) {
    EXPECT_EQ(find_self_intersections_of(cut, tree, faces), filtered(all, faces));
    EXPECT_EQ(find_self_intersections_of(cut, soup, faces).listed, filtered(all, faces));
  }
  return all.size();
}

/// Faces over random vertices, some of them degenerate, some twice, whatever order their corners
/// come in.
Soup random_faces(Index n_vertices, Index n_faces, const std::function<Vec3(Random&)>& point,
                  Random& random) {
  Soup soup;
  for (Index i = 0; i < n_vertices; ++i) {
    soup.positions.push_back(point(random));
  }
  for (Index i = 0; i < n_faces; ++i) {
    soup.triangles.push_back(
        {below(random, n_vertices), below(random, n_vertices), below(random, n_vertices)});
  }
  return damaged(soup, 8, random);
}

TEST(FindSelfIntersectionsOf, RandomSoupsGiveThoseOfTheWholeThatHaveAFaceAskedFor) {
  Random random(11);
  const auto real = [](Random& r) { return std::uniform_real_distribution<>(-1, 1)(r); };
  for (int round = 0; round < 10; ++round) {
    const Soup soup = random_faces(
        40, 120, [&](Random& r) { return Vec3(real(r), real(r), real(r)); }, random);
    EXPECT_GT(expect_filtered(soup, random), 100u);
  }
}

TEST(FindSelfIntersectionsOf, LatticesWithFacesOfZeroAreaGiveThoseOfTheWhole) {
  Random random(12);
  const auto lattice = [](Random& r) { return static_cast<double>(below(r, 4)); };
  for (int round = 0; round < 10; ++round) {
    const Soup flat = random_faces(
        30, 100, [&](Random& r) { return Vec3(lattice(r), lattice(r), 0); }, random);
    EXPECT_GT(expect_filtered(flat, random), 100u);
    const Soup solid = random_faces(
        40, 100, [&](Random& r) { return Vec3(lattice(r), lattice(r), lattice(r)); }, random);
    EXPECT_GT(expect_filtered(solid, random), 100u);
  }
}

TEST(FindSelfIntersectionsOf, MeshesOfManyLeavesGiveThoseOfTheWhole) {
  Random random(13);
  const Soup spheres = shapes::merged(
      shapes::uv_sphere(40, 60), shapes::translated(shapes::uv_sphere(39, 55), {0.9, 0.3, 0.2}));
  EXPECT_GT(expect_filtered(shapes::shuffled_faces(spheres, 1), random), 100u);
  EXPECT_GT(expect_filtered(damaged(spheres, 20, random), random), 100u);
}

TEST(FindSelfIntersectionsOf, BundlesOfSliversGiveThoseOfTheWhole) {
  Random random(14);
  const Soup soup =
      shapes::merged(test::sliver_tube(400, {20, 22, 18}),
                     shapes::translated(test::sliver_tube(300, {20, 21, 19}), {0.3, -0.4, 0.1}));
  EXPECT_GT(expect_filtered(soup, random), 100u);
}

TEST(FindSelfIntersectionsOf, FansRoundOneVertexGiveThoseOfTheWhole) {
  Random random(15);
  // Faces of a wide fan that a second one on the same vertex passes through.
  Soup soup;
  soup.positions = {Vec3(0, 0, 0)};
  const auto add_fan = [&](const Vec3& u, const Vec3& v) {
    const auto first = static_cast<Index>(soup.n_vertices());
    for (Index i = 0; i <= 200; ++i) {
      const double angle = 0.01 * i - 0.9;
      soup.positions.emplace_back(std::cos(angle) * u + std::sin(angle) * v);
    }
    for (Index i = 0; i < 200; ++i) {
      soup.triangles.push_back({0, first + i, first + i + 1});
    }
  };
  add_fan({100, 0, 0}, {0, 100, 0});
  add_fan({1, 0.1, 0}, {0, 0, 1});
  EXPECT_GT(expect_filtered(shapes::shuffled_faces(soup, 3), random), 0u);
}

TEST(FindSelfIntersectionsOf, GoodMeshHasNone) {
  Random random(16);
  EXPECT_EQ(expect_filtered(shapes::torus(2, 0.5, 30, 20), random), 0u);
}

TEST(FindSelfIntersectionsOf, FacesInNoComplexMeetNothing) {
  // Face 1 repeats a vertex, face 3 has one that is missing; 0 and 2 cross.
  const Soup soup =
      shapes::make({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, -1}, {0.5, 0.5, 1}, {3, 3, 1}},
                   {{0, 1, 2}, {3, 3, 4}, {3, 4, 5}, {3, 4, kNoIndex}});
  const CutMesh cut = build(soup);
  const FaceTree tree(cut);
  EXPECT_EQ(find_self_intersections_of(cut, tree, Faces{1, 3}), Pairs{});
  const Pairs crossing{{.face_a = 0, .face_b = 2, .kind = ContactKind::Crossing}};
  EXPECT_EQ(find_self_intersections_of(cut, tree, Faces{1, 2, 3}), crossing);
}

TEST(FindSelfIntersectionsOf, MeshWithoutFacesHasNone) {
  const CutMesh cut = build(shapes::make({{0, 0, 0}}, {{0, 0, 0}}));
  EXPECT_EQ(find_self_intersections_of(cut, FaceTree(cut), Faces{0}), Pairs{});
}

TEST(FindSelfIntersectionsOf, SearchEndsAfterSoManyTests) {
  // All pairs of these faces are tested one by one, because they cross near the origin.
  Random random(18);
  Soup soup;
  for (Index f = 0; f < 1500; ++f) {
    const auto first = static_cast<Index>(soup.n_vertices());
    for (int corner = 0; corner < 3; ++corner) {
      const auto any = [&] { return uniform(random, -1.0, 1.0); };
      soup.positions.push_back(Vec3(any(), any(), any()));
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const CutMesh cut = build(soup);
  const FaceTree tree(cut);
  const Faces faces = all_of(soup);
  const Pairs all = find_self_intersections_of(cut, tree, faces);
  const auto within = [&](std::size_t max_tested) {
    return find_self_intersections_of(cut, tree, faces,
                                      {.max_tested = max_tested, .wants_to_stop = {}});
  };
  const FoundPairs enough = within(faces.size() * faces.size());
  EXPECT_TRUE(enough.is_complete);
  EXPECT_EQ(enough.listed, all);
  const ThreadLimit two(2);
  const FoundPairs some = within(100'000);
  EXPECT_FALSE(some.is_complete);
  EXPECT_LT(some.listed.size(), all.size());
  EXPECT_TRUE(std::includes(all.begin(), all.end(), some.listed.begin(), some.listed.end(),
                            [](const auto& p, const auto& q) {
                              return std::pair(p.face_a, p.face_b) < std::pair(q.face_a, q.face_b);
                            }));
  const ThreadLimit one(1);
  EXPECT_EQ(within(100'000).listed, some.listed);
}

TEST(FindSelfIntersectionsOf, ThreadCountDoesNotMatter) {
  Random random(17);
  const Soup soup = shapes::merged(shapes::uv_sphere(90, 90),
                                   shapes::translated(shapes::uv_sphere(80, 90), {0.9, 0.3, 0.2}));
  const CutMesh cut = build(soup);
  const FaceTree tree(cut);
  const Faces faces = some_of(soup, 3, random);
  const ThreadLimit two(2);
  const Pairs by_two = find_self_intersections_of(cut, tree, faces);
  const ThreadLimit one(1);
  EXPECT_EQ(find_self_intersections_of(cut, tree, faces), by_two);
  EXPECT_FALSE(by_two.empty());
}

}  // namespace
}  // namespace meshalyzer
