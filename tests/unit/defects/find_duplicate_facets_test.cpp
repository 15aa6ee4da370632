#include "meshalyzer/defects/finders.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

using FaceSets = std::vector<std::vector<Index>>;

FaceSets duplicates_in(const Soup& soup) {
  FaceSets sets;
  for (const Defect& defect : find_duplicate_facets(PreparedMesh(soup))) {
    EXPECT_EQ(defect.code, DefectCode::DuplicateFacet);
    EXPECT_EQ(defect.value, static_cast<double>(defect.faces.size()));
    EXPECT_EQ(defect.positions.size(), 1U);
    sets.push_back(defect.faces);
  }
  return sets;
}

TEST(FindDuplicateFacets, DifferentFacesAreNot) {
  EXPECT_TRUE(duplicates_in({}).empty());
  EXPECT_TRUE(duplicates_in(shapes::cube()).empty());
  EXPECT_TRUE(duplicates_in(shapes::fan_of_three()).empty());
}

TEST(FindDuplicateFacets, SamePlacesUnderOtherNumbersAreNot) {
  EXPECT_TRUE(duplicates_in(shapes::merged(shapes::cube(), shapes::cube())).empty());
}

TEST(FindDuplicateFacets, FacesBackToBackAre) {
  EXPECT_EQ(duplicates_in(shapes::pillow()), (FaceSets{{0, 1}}));
}

TEST(FindDuplicateFacets, AllOfASetAreListedAndSetsByTheirFirstFace) {
  Soup soup = shapes::cube();
  const Triangle late = soup.triangles[9];
  const Triangle early = soup.triangles[2];
  soup.triangles.push_back({late[1], late[2], late[0]});
  soup.triangles.push_back({early[1], early[0], early[2]});
  soup.triangles.push_back(late);
  EXPECT_EQ(duplicates_in(soup), (FaceSets{{2, 13}, {9, 12, 14}}));
}

TEST(FindDuplicateFacets, FacesThatAreNotInTheComplexAreNot) {
  Soup soup = shapes::tetrahedron();
  soup.triangles.push_back({0, 0, 1});
  soup.triangles.push_back({0, 0, 1});
  soup.triangles.push_back({0, 1, kNoIndex});
  soup.triangles.push_back({0, 1, kNoIndex});
  EXPECT_TRUE(duplicates_in(soup).empty());
}

TEST(FindDuplicateFacets, AgreesWithAMapOnDamagedMeshes) {
  std::mt19937 random(20270114);
  for (Index round = 0; round < 50; ++round) {
    const Soup soup = damaged(shapes::icosphere(2), 2 + round % 9, random);
    std::map<Triangle, std::vector<Index>> faces;
    for (Index f = 0; f < soup.n_faces(); ++f) {
      Triangle t = soup.triangles[f];
      std::sort(t.begin(), t.end());
      faces[t].push_back(f);
    }
    FaceSets expected;
    for (const auto& [key, set] : faces) {
      if (set.size() > 1) expected.push_back(set);
    }
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(duplicates_in(soup), expected);
  }
}

}  // namespace
}  // namespace meshalyzer
