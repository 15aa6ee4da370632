#include "meshalyzer/prepared/prepared_mesh.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Two cubes that cross: both have intersecting faces.
Soup crossing_cubes() {
  return shapes::merged(shapes::cube(), shapes::cube(1.0, {0.5, 0.25, 0.125}));
}

TEST(PreparedMesh, EachPartIsBuiltOnceHoweverManyAsk) {
  const Soup soup = crossing_cubes();
  const PreparedMesh mesh(soup);
  struct Seen {
    const FaceTree* tree;
    const Components* components;
    const Box3* boxes;
    const IntersectingPair* pairs;
    const Shell* shells;
    auto operator<=>(const Seen&) const = default;
  };
  std::vector<Seen> seen(64);
  parallel_chunks(seen.size(), 1, [&](Chunk chunk) {
    // In another order each, so that each part is asked for first by some.
    Seen& each = seen[chunk.number];
    if (chunk.number % 2 == 0) each.shells = mesh.shells().data();
    each.pairs = mesh.intersecting_pairs().data();
    each.tree = &mesh.tree();
    each.components = &mesh.components();
    each.boxes = mesh.component_boxes().data();
    each.shells = mesh.shells().data();
  });
  EXPECT_EQ(std::set<Seen>(seen.begin(), seen.end()).size(), 1U);
}

TEST(PreparedMesh, KnowsItsRecordsUntilTheyAreReleased) {
  auto soup = std::make_shared<const Soup>(crossing_cubes());
  const std::weak_ptr<const Soup> watched = soup;
  PreparedMesh mesh(std::move(soup));
  EXPECT_EQ(mesh.soup().n_faces(), 24U);
  mesh.release_soup();
  EXPECT_TRUE(watched.expired());
  EXPECT_THROW(static_cast<void>(mesh.soup()), InvalidArgument);
}

TEST(PreparedMesh, NeedsNoRecordsForWhatIsBuilt) {
  const Soup soup = crossing_cubes();
  const PreparedMesh whole(soup);
  auto gone = std::make_unique<Soup>(soup);
  PreparedMesh mesh(*gone);
  mesh.release_soup();
  gone.reset();
  EXPECT_EQ(mesh.components().of_face, whole.components().of_face);
  EXPECT_EQ(mesh.intersecting_pairs(), whole.intersecting_pairs());
  EXPECT_EQ(mesh.shells().size(), 2U);
}

TEST(PreparedMesh, BelievesThePairsThatItIsTold) {
  const Soup soup = crossing_cubes();
  const std::vector<IntersectingPair> told{{0, 12, ContactKind::Crossing}};
  PreparedMesh mesh(soup);
  mesh.set_intersecting_pairs(told);
  EXPECT_EQ(mesh.intersecting_pairs(), told);
}

TEST(PreparedMesh, PairsCanBeTakenAwayAtTheEnd) {
  const Soup soup = crossing_cubes();
  PreparedMesh mesh(soup);
  const IntersectingPair* data = mesh.intersecting_pairs().data();
  const std::vector<IntersectingPair> taken = std::move(mesh).intersecting_pairs();
  EXPECT_EQ(taken.data(), data);
  EXPECT_FALSE(taken.empty());
}

/// Counts the pairs of a mesh by a loop over all of them.
IntersectionCounts counted(const PreparedMesh& mesh, const std::vector<IntersectingPair>& pairs) {
  IntersectionCounts counts;
  counts.kinds.add(pairs);
  counts.intersects.resize(mesh.cut().side.faces.size(), 0);
  counts.of_component.resize(mesh.components().count, 0);
  for (const IntersectingPair& pair : pairs) {
    const std::size_t f = mesh.cut().side.mesh_face(pair.face_a);
    const std::size_t g = mesh.cut().side.mesh_face(pair.face_b);
    counts.intersects[f] = counts.intersects[g] = 1;
    std::set<Index> of{mesh.components().of_face[f], mesh.components().of_face[g]};
    for (const Index component : of) ++counts.of_component[component];
  }
  return counts;
}

void expect_same_counts(const PreparedMesh& mesh, const IntersectionCounts& expected) {
  const IntersectionCounts& counts = mesh.intersection_counts();
  EXPECT_EQ(counts.kinds, expected.kinds);
  EXPECT_EQ(counts.intersects, expected.intersects);
  EXPECT_EQ(counts.of_component, expected.of_component);
  EXPECT_TRUE(counts.is_complete);
}

/// Faces with the same three vertices, in the way of other meshes, and loose ones at their place.
Soup pile() {
  Soup soup = shapes::make({{0, 0, 0.3}, {1, 0, 0.3}, {0, 1, 0.3}}, {});
  for (int i = 0; i < 40; ++i) soup.triangles.push_back({0, 1, 2});
  const Soup loose = shapes::make({{0, 0, 0.3}, {1, 0, 0.3}, {0, 1, 0.3}}, {{0, 1, 2}});
  for (int i = 0; i < 40; ++i) soup = shapes::merged(soup, loose);
  return soup;
}

TEST(PreparedMesh, CountsPairsThatItDoesNotList) {
  // Loose triangles, two cubes that cross, one that touches nothing and one that encloses it.
  Soup soup = shapes::merged(shapes::tangle(150), crossing_cubes());
  soup = shapes::merged(soup,
                        shapes::merged(shapes::cube(1.0, {9, 9, 9}), shapes::cube(3.0, {8, 8, 8})));
  soup = shapes::merged(soup, pile());
  const PreparedMesh whole(soup);
  const std::vector<IntersectingPair> all = whole.intersecting_pairs();
  const IntersectionCounts expected = counted(whole, all);
  expect_same_counts(whole, expected);
  for (const std::size_t n_threads : {1, 2, 5}) {
    const ThreadLimit limit(n_threads);
    for (const std::size_t max_listed : {1, 17, 1000}) {
      const PreparedMesh mesh(soup, {.max_listed = max_listed, .wants_to_stop = {}});
      expect_same_counts(mesh, expected);
      EXPECT_EQ(mesh.intersecting_pairs(),
                std::vector(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(max_listed)));
      for (std::size_t c = 0; c < whole.shells().size(); ++c) {
        EXPECT_EQ(mesh.shells()[c].outward, whole.shells()[c].outward);
        EXPECT_EQ(mesh.shells()[c].inside, whole.shells()[c].inside);
      }
    }
  }
}

TEST(PreparedMesh, SearchThatIsToldToStopKnowsNoShellsOfSeveralComponents) {
  const Soup soup = crossing_cubes();
  const PreparedMesh mesh(soup, {.wants_to_stop = [] { return true; }});
  EXPECT_FALSE(mesh.was_intersection_search_cut());  // nobody has searched
  EXPECT_TRUE(mesh.intersecting_pairs().empty());
  EXPECT_TRUE(mesh.was_intersection_search_cut());
  EXPECT_EQ(mesh.shells().at(0).outward, std::nullopt);
  EXPECT_EQ(mesh.shells().at(0).volume, 1.0);
}

TEST(PreparedMesh, SearchThatHasFoundEnoughKnowsNoShellsOfSeveralComponents) {
  const Soup soup = crossing_cubes();
  const std::size_t n_pairs = PreparedMesh(soup).intersecting_pairs().size();
  const PreparedMesh few(soup, {.max_found = n_pairs - 1, .wants_to_stop = {}});
  EXPECT_EQ(few.intersecting_pairs().size(), n_pairs - 1);
  EXPECT_TRUE(few.was_intersection_search_cut());
  EXPECT_FALSE(few.intersection_counts().is_complete);
  EXPECT_EQ(few.shells().at(0).outward, std::nullopt);
  EXPECT_EQ(few.shells().at(0).volume, 1.0);

  const PreparedMesh enough(soup, {.max_found = n_pairs, .wants_to_stop = {}});
  EXPECT_EQ(enough.intersecting_pairs().size(), n_pairs);
  EXPECT_FALSE(enough.was_intersection_search_cut());
  EXPECT_EQ(enough.shells().at(0).outward, true);
}

TEST(PreparedMesh, MeshWithoutFacesHasNoParts) {
  const Soup soup;
  const PreparedMesh mesh(soup);
  EXPECT_EQ(mesh.components().count, 0U);
  EXPECT_TRUE(mesh.component_boxes().empty());
  EXPECT_TRUE(mesh.intersecting_pairs().empty());
  EXPECT_TRUE(mesh.shells().empty());
}

TEST(PreparedMesh, RecordsThatAreNullAreRefused) {
  EXPECT_THROW(PreparedMesh(std::shared_ptr<const Soup>()), InvalidArgument);
}

TEST(PreparedMesh, WithAPositionThatIsNotFiniteHasConnectivityAlone) {
  Soup soup = shapes::cube();
  soup.positions[1].z() = std::numeric_limits<double>::quiet_NaN();
  PreparedMesh mesh(soup);
  EXPECT_EQ(mesh.components().count, 1U);
  mesh.release_soup();
  EXPECT_THROW(static_cast<void>(std::as_const(mesh).tree()), InvalidArgument);
  EXPECT_THROW(static_cast<void>(std::as_const(mesh).intersecting_pairs()), InvalidArgument);
  EXPECT_THROW(static_cast<void>(std::as_const(mesh).shells()), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
