#include "meshalyzer/picture/internal/neighbourhoods.h"

#include "meshalyzer/picture/internal/drawn_surface.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

/// The faces within so many rings of some vertices, straight from the definition.
std::set<Index> rings(const Soup& soup, std::set<Index> vertices, int n_rings) {
  std::set<Index> faces;
  for (int ring = 0; ring < n_rings; ++ring) {
    for (Index f = 0; f < soup.n_faces(); ++f) {
      const Triangle& t = soup.triangles[f];
      if (std::any_of(t.begin(), t.end(), [&](Index v) { return vertices.contains(v); })) {
        faces.insert(f);
      }
    }
    for (const Index f : faces) {
      vertices.insert(soup.triangles[f].begin(), soup.triangles[f].end());
    }
  }
  return faces;
}

std::vector<Index> listed(const std::set<Index>& faces) {
  return {faces.begin(), faces.end()};
}

/// Vertex (x, y) of a grid that is n squares wide.
Index grid_vertex(Index x, Index y, Index n) {
  return y * (n + 1) + x;
}

TEST(FacesRound, WithoutSeedsThereAreNone) {
  const Soup soup = shapes::grid(5, 5);
  EXPECT_TRUE(faces_round(soup, drawable_faces(soup), {}, 100).empty());
}

TEST(FacesRound, RingsAreWholeWhereTheyFit) {
  const Soup soup = shapes::shuffled_faces(shapes::grid(20, 20), 5);
  const Index a = grid_vertex(4, 5, 20);
  const Index b = grid_vertex(14, 12, 20);
  for (int n_rings = 1; n_rings < 4; ++n_rings) {
    const std::set<Index> wanted = rings(soup, {a, b}, n_rings);
    EXPECT_EQ(faces_round(soup, drawable_faces(soup), {{}, {a, b}}, wanted.size()), listed(wanted));
  }
}

TEST(FacesRound, PartOfARingHasAllOfTheRingsBefore) {
  const Soup soup = shapes::grid(20, 20);
  const Index middle = grid_vertex(10, 10, 20);
  const std::set<Index> two = rings(soup, {middle}, 2);
  const std::set<Index> three = rings(soup, {middle}, 3);
  const std::vector<Index> faces =
      faces_round(soup, drawable_faces(soup), {{}, {middle}}, two.size() + 5);
  EXPECT_EQ(faces.size(), two.size() + 5);
  EXPECT_TRUE(std::includes(faces.begin(), faces.end(), two.begin(), two.end()));
  EXPECT_TRUE(std::includes(three.begin(), three.end(), faces.begin(), faces.end()));
}

TEST(FacesRound, FacesOfSeedsComeFirstAndInTheirOrder) {
  const Soup soup = shapes::grid(20, 20);
  EXPECT_EQ(faces_round(soup, drawable_faces(soup), {{700, 3, 350}, {}}, 2),
            (std::vector<Index>{3, 700}));
}

TEST(FacesRound, WalkEndsWithTheComponentOfTheSeeds) {
  const Soup soup = shapes::merged(shapes::cube(), shapes::icosphere(2));
  const std::vector<Index> faces = faces_round(soup, drawable_faces(soup), {{5}, {}}, 100);
  EXPECT_EQ(faces, (std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
}

TEST(FacesRound, FacesThatCannotBeDrawnAreNotWalkedOn) {
  Soup soup = shapes::cube();
  soup.triangles[4][1] = kNoIndex;
  const std::vector<Index> faces = faces_round(soup, drawable_faces(soup), {{5}, {}}, 100);
  EXPECT_EQ(faces, (std::vector<Index>{0, 1, 2, 3, 5, 6, 7, 8, 9, 10, 11}));
}

}  // namespace
}  // namespace meshalyzer
