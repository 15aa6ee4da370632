#include "meshalyzer/repair/cut/internal/closed_part.h"

#include "support/arranged_mesh.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace meshalyzer {
namespace {

ClosedPart closed_part_of_all(const Soup& soup) {
  const test::ArrangedMesh mesh(soup);
  return find_closed_part(mesh.arranged, std::vector<std::uint8_t>(mesh.cells.n_components, 1));
}

TEST(FindClosedPart, SheetThroughSolidTellsInsideAndIsNotOfChain) {
  // A square across the cube [0, 2]^3 reaches out of it on all four sides.
  const Soup soup = shapes::merged(
      shapes::cube(2), shapes::make({{-1, -1, 1}, {3, -1, 1.25}, {3, 3, 1.5}, {-1, 3, 1.25}},
                                    {{0, 1, 2}, {0, 2, 3}}));
  const ClosedPart part = closed_part_of_all(soup);
  EXPECT_EQ(part.tells_inside, std::vector<std::uint8_t>{1});
  EXPECT_EQ(part.encloses_rest, std::vector<std::uint8_t>{0});
  EXPECT_EQ(part.is_loose, std::vector<std::uint8_t>{0});
}

TEST(FindClosedPart, FacesWithoutPiecesCountForNoComponent) {
  // Three corners at two places of the tetrahedron: nothing is left of such a face once its corners
  // are united with those of the tetrahedron. Its edges, which no other face has, are no border of
  // the tetrahedron, whichever faces come first.
  const Soup soup = shapes::make(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      {{4, 1, 5}, {4, 2, 6}, {4, 3, 7}, {0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  for (const bool is_flat_first : {true, false}) {
    Soup turned = soup;
    if (!is_flat_first) std::reverse(turned.triangles.begin(), turned.triangles.end());
    const ClosedPart part = closed_part_of_all(turned);
    EXPECT_EQ(part.is_loose, std::vector<std::uint8_t>{0});
    EXPECT_EQ(part.is_of_chain.size(), 4U);
  }
}

}  // namespace
}  // namespace meshalyzer
