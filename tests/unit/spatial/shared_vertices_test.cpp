#include "meshalyzer/spatial/shared_vertices.h"

#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

/// A cone of n faces, all of which have the first vertex, at one corner or another.
Soup cone(std::size_t n) {
  std::vector<Vec3> positions{Vec3(0, 0, 1)};
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    positions.push_back(Vec3(std::cos(angle), std::sin(angle), 0));
    Triangle t{0, static_cast<Index>(i + 1), static_cast<Index>((i + 1) % n + 1)};
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(i % 3), t.end());
    triangles.push_back(t);
  }
  return shapes::make(positions, triangles);
}

/// The vertices of each leaf, by asking all faces.
std::vector<std::set<Index>> vertices_of_leaves(const FaceTree& tree) {
  std::vector<std::set<Index>> all(tree.n_leaves());
  for (std::size_t slot = 0; slot < tree.n_faces(); ++slot) {
    const Triangle t = tree.triangle(slot);
    all[slot / 8].insert(t.begin(), t.end());
  }
  return all;
}

struct LeavesOfMesh {
  explicit LeavesOfMesh(const Soup& soup) : cut(build(soup)) {}
  CutMesh cut;
  FaceTree tree{cut};
  CornerAngles angles{tree, {}};
  SharedVertices shared{tree, angles};
  std::vector<std::set<Index>> vertices = vertices_of_leaves(tree);
};

std::vector<Soup> meshes() {
  // Vertices of 17 leaves are hubs, those of 16 are not.
  return {
      shapes::icosphere(3),  cone(300),    shapes::merged(cone(1000), shapes::torus(1, 0.3, 9, 7)),
      shapes::tetrahedron(), cone(8 * 16), cone(8 * 17)};
}

TEST(SharedVertices, NeighboursAndHubsAreThoseFoundByComparingAllLeaves) {
  std::size_t n_hubs = 0;
  for (const Soup& soup : meshes()) {
    const LeavesOfMesh mesh(soup);
    std::map<Index, std::size_t> n_leaves;
    for (const std::set<Index>& vertices : mesh.vertices) {
      for (const Index v : vertices) ++n_leaves[v];
    }
    for (std::size_t a = 0; a < mesh.tree.n_leaves(); ++a) {
      std::vector<Index> hubs;
      std::vector<Index> others;
      for (const Index v : mesh.vertices[a]) (n_leaves[v] > 16 ? hubs : others).push_back(v);
      std::vector<Index> near;
      for (std::size_t b = 0; b < mesh.tree.n_leaves(); ++b) {
        if (std::ranges::any_of(others, [&](Index v) { return mesh.vertices[b].contains(v); })) {
          near.push_back(static_cast<Index>(b));
        }
      }
      EXPECT_TRUE(std::ranges::equal(mesh.shared.neighbours(a), near));
      EXPECT_TRUE(std::ranges::equal(mesh.shared.hubs(a), hubs, {}, &LeafVertex::vertex));
      n_hubs += hubs.size();
    }
  }
  // The cones of 300, 1,000 and 136 faces have one hub each, in all of their leaves.
  EXPECT_GT(n_hubs, 17U + 38U + 125U - 1U);
}

TEST(SharedVertices, HubNamesItsFacesAndTheirCorners) {
  for (const Soup& soup : meshes()) {
    const LeavesOfMesh mesh(soup);
    for (std::size_t leaf = 0; leaf < mesh.tree.n_leaves(); ++leaf) {
      for (const LeafVertex& hub : mesh.shared.hubs(leaf)) {
        for (std::size_t i = 0; i < 8; ++i) {
          const bool has_it = (hub.lanes >> i & 1U) != 0;
          if (8 * leaf + i >= mesh.tree.n_faces()) {
            EXPECT_FALSE(has_it);
            continue;
          }
          const Triangle t = mesh.tree.triangle(8 * leaf + i);
          EXPECT_EQ(has_it, std::ranges::count(t, hub.vertex) == 1);
          EXPECT_TRUE(!has_it || t[hub.corner(i)] == hub.vertex);
        }
      }
    }
  }
}

TEST(SharedVertices, LeavesAtAHubAreApartOnlyWhereAllOfTheirFacesAre) {
  const LeavesOfMesh mesh(cone(1000));
  ASSERT_FALSE(mesh.angles.empty());
  std::size_t n_apart = 0;
  for (std::size_t a = 0; a < mesh.tree.n_leaves(); ++a) {
    const LeafVertex& mine = mesh.shared.hubs(a).front();
    for (std::size_t b = 0; b < mesh.tree.n_leaves(); ++b) {
      const LeafVertex& theirs = mesh.shared.hubs(b).front();
      if (!mine.angles.is_apart_from(theirs.angles)) continue;
      ++n_apart;
      for (std::size_t i = 0; i < 8; ++i) {
        for (std::size_t j = 0; j < 8; ++j) {
          EXPECT_TRUE(
              mesh.angles.are_apart(8 * a + i, mine.corner(i), 8 * b + j, theirs.corner(j)));
        }
      }
    }
  }
  // Each of the 125 leaves is apart from nearly all others.
  EXPECT_GT(n_apart, std::size_t{125 * 100});
}

}  // namespace
}  // namespace meshalyzer
