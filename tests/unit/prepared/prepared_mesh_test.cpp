#include "meshalyzer/prepared/prepared_mesh.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

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

TEST(PreparedMesh, MeshWithoutFacesHasNoParts) {
  const Soup soup;
  const PreparedMesh mesh(soup);
  EXPECT_EQ(mesh.components().count, 0U);
  EXPECT_TRUE(mesh.component_boxes().empty());
  EXPECT_TRUE(mesh.intersecting_pairs().empty());
  EXPECT_TRUE(mesh.shells().empty());
}

}  // namespace
}  // namespace meshalyzer
