#include "meshalyzer/repair/split/internal/walls_between_cells.h"

#include "support/shapes.h"
#include "unit/repair/cell_complex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Returns the faces of all walls between cells, ascending.
std::vector<Index> walls_of(const Soup& soup) {
  std::vector<Index> walls;
  for (const auto& set : find_walls_between_cells(PreparedMesh(soup), {}).sets) {
    walls.insert(walls.end(), set.begin(), set.end());
  }
  std::sort(walls.begin(), walls.end());
  return walls;
}

/// Three cubes in a row, each a cell.
CellComplex::Faces three_cubes() {
  CellComplex complex({3, 1, 1});
  for (int x = 0; x < 3; ++x) complex.assign({x, 0, 0}, x + 1);
  return complex.faces();
}

TEST(WallsBetweenCells, WallsThatMeetNowhereAreReturnedApart) {
  const CellComplex::Faces faces = three_cubes();
  const auto sets = find_walls_between_cells(PreparedMesh(faces.soup), {}).sets;
  ASSERT_EQ(sets.size(), 2U);
  EXPECT_EQ(sets[0], (std::vector<Index>{faces.walls[0], faces.walls[1]}));
  EXPECT_EQ(sets[1], (std::vector<Index>{faces.walls[2], faces.walls[3]}));
}

TEST(WallsBetweenCells, AllAreFoundWhereverTheyPoint) {
  std::mt19937 random(11);
  for (int i = 0; i < 40; ++i) {
    CellComplex::Faces faces = random_complex({2, 3, 3}, 4, random).faces();
    for (const Index wall : faces.walls) {
      Triangle& t = faces.soup.triangles[wall];
      if (random() % 2 == 0) std::swap(t[0], t[1]);
    }
    EXPECT_EQ(walls_of(faces.soup), faces.walls) << i;
  }
}

/// A block with a cavity that has an edge in common with a notch in the surface; at one end of the
/// block is another cell.
CellComplex block_with_cavity() {
  CellComplex complex({3, 3, 4});
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (int z = 0; z < 4; ++z) {
        const bool is_cavity = x == 1 && y == 1 && z == 1;
        const bool is_notch = x == 0 && y == 0 && z < 3;
        if (!is_cavity && !is_notch) complex.assign({x, y, z}, z == 3 ? 2 : 1);
      }
    }
  }
  return complex;
}

TEST(WallsBetweenCells, CavityIsNone) {
  EXPECT_TRUE(walls_of(shapes::nested_cubes(shapes::InnerShell::Cavity)).empty());
  CellComplex::Faces faces = block_with_cavity().faces();
  EXPECT_EQ(walls_of(faces.soup), faces.walls);
  // A fin, from the edge between the cavity and the notch into the notch.
  const auto at = [&](const Vec3& p) {
    const auto& all = faces.soup.positions;
    return static_cast<Index>(std::find(all.begin(), all.end(), p) - all.begin());
  };
  faces.soup.triangles.push_back(
      {at({1, 1, 1}), at({1, 1, 2}), static_cast<Index>(faces.soup.n_vertices())});
  faces.soup.positions.emplace_back(0.5, 0.5, 1.5);
  EXPECT_EQ(walls_of(faces.soup), faces.walls);
}

TEST(WallsBetweenCells, WallThatIsStoredTwiceIsNone) {
  EXPECT_TRUE(walls_of(shapes::two_tetrahedra_sharing_face()).empty());
}

TEST(WallsBetweenCells, WallOfAnOpenCellIsNone) {
  const CellComplex::Faces faces = three_cubes();
  // A face of the first cell.
  const Triangle& wall = faces.soup.triangles[faces.walls[0]];
  ASSERT_EQ(faces.soup.positions[wall[0]].x(), 1.0);
  Index open = 0;
  while (std::any_of(faces.soup.triangles[open].begin(), faces.soup.triangles[open].end(),
                     [&](Index v) { return faces.soup.positions[v].x() != 0.0; })) {
    ++open;
  }
  const Soup soup = shapes::without_faces(faces.soup, std::vector<Index>{open});
  EXPECT_EQ(walls_of(soup), (std::vector<Index>{faces.walls[2] - 1, faces.walls[3] - 1}));
}

TEST(WallsBetweenCells, FinInsideACellIsNone) {
  // A triangle at an edge of the cube, and with its tip inside it.
  Soup soup = shapes::cube(2.0);
  soup.positions.emplace_back(1, 1, 1);
  const Triangle& t = soup.triangles[0];
  soup.triangles.push_back({t[0], t[1], static_cast<Index>(soup.n_vertices() - 1)});
  EXPECT_TRUE(walls_of(soup).empty());
}

TEST(WallsBetweenCells, SurfacesWithIntersectionsHaveNoCells) {
  const CellComplex::Faces faces = three_cubes();
  // A small cube through a side of the first one.
  const Soup soup = shapes::merged(faces.soup, shapes::box({-0.2, 0.4, 0.4}, {0.2, 0.6, 0.6}));
  EXPECT_TRUE(walls_of(soup).empty());
  // The same beside it.
  const Soup apart = shapes::merged(faces.soup, shapes::box({-0.8, 0.4, 0.4}, {-0.2, 0.6, 0.6}));
  EXPECT_EQ(walls_of(apart), faces.walls);
}

}  // namespace
}  // namespace meshalyzer
