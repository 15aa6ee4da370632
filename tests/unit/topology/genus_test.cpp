#include "meshalyzer/topology/genus.h"

#include "meshalyzer/mesh/build.h"
#include "meshalyzer/topology/boundary.h"
#include "meshalyzer/topology/edges.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>

namespace meshalyzer {
namespace {

/// Returns the genus of a mesh of one component without orphans.
std::optional<std::int64_t> genus_of(const Soup& soup) {
  const CutMesh cut = build(soup);
  return genus({.vertices = soup.n_vertices(),
                .edges = n_edges(cut),
                .faces = soup.n_faces(),
                .boundaries = find_boundary_loops(cut).size()});
}

TEST(Genus, SpheresHaveNone) {
  EXPECT_EQ(genus_of(shapes::tetrahedron()), 0);
  EXPECT_EQ(genus_of(shapes::cube()), 0);
  EXPECT_EQ(genus_of(shapes::uv_sphere(5, 7)), 0);
  EXPECT_EQ(genus_of(shapes::icosphere(3)), 0);
  EXPECT_EQ(genus_of(shapes::pillow()), 0);
}

TEST(Genus, TorusHasOne) {
  EXPECT_EQ(genus_of(shapes::torus(3, 1, 3, 3)), 1);
  EXPECT_EQ(genus_of(shapes::torus(3, 1, 12, 7)), 1);
}

TEST(Genus, EveryHoleThroughABlockIsOne) {
  for (std::size_t n = 0; n < 6; ++n) {
    SCOPED_TRACE(n);
    EXPECT_EQ(genus_of(shapes::genus_block(n)), static_cast<std::int64_t>(n));
  }
}

TEST(Genus, BoundariesDoNotChangeIt) {
  const std::array<Index, 2> faces{0, 20};
  EXPECT_EQ(genus_of(shapes::grid(4, 3)), 0);
  EXPECT_EQ(genus_of(shapes::open_cube()), 0);
  EXPECT_EQ(genus_of(shapes::without_faces(shapes::torus(3, 1, 6, 5), faces)), 1);
}

TEST(Genus, OddRemainderHasNone) {
  // The projective plane: 6 - 15 + 10 = 1.
  EXPECT_EQ(genus_of(shapes::projective_plane()), std::nullopt);
}

TEST(Genus, SeveralSpheresAtOnceHaveNone) {
  // Two cubes: 16 - 36 + 24 = 4, more than any one component can have.
  EXPECT_EQ(genus({.vertices = 16, .edges = 36, .faces = 24, .boundaries = 0}), std::nullopt);
}

}  // namespace
}  // namespace meshalyzer
