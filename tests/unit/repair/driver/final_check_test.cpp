#include "meshalyzer/repair/driver/internal/final_check.h"

#include "support/random_soups.h"
#include "support/run_pass.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>

namespace meshalyzer {
namespace {

/// Gives some faces corners of their own, at the same places, where 0 may be -0.
Soup with_copied_corners(Soup soup, std::size_t n, std::mt19937& random) {
  for (std::size_t i = 0; i < n; ++i) {
    Triangle& t = soup.triangles[below(random, static_cast<Index>(soup.n_faces()))];
    Index& corner = t[below(random, 3)];
    const Vec3 place = soup.positions[corner];
    soup.positions.emplace_back((place.array() == 0.0).select(-place, place));
    corner = static_cast<Index>(soup.n_vertices() - 1);
  }
  return soup;
}

/// Names the first vertex at each place in all faces.
Soup with_equal_points_merged(Soup soup) {
  for (Triangle& t : soup.triangles) {
    for (Index& v : t) {
      const auto first = std::find(soup.positions.begin(), soup.positions.end(), soup.positions[v]);
      v = static_cast<Index>(first - soup.positions.begin());
    }
  }
  return soup;
}

TEST(FinalCheck, MeshWithEqualPointsMergedIsListedAsIfItWereSearchedAnew) {
  std::mt19937 random(11);
  for (std::size_t n = 0; n < 60; n += 3) {
    Soup soup = shapes::merged(shapes::icosphere(1),
                               shapes::translated(shapes::icosphere(1), Vec3(0.3, 0.2, 0.1)));
    soup = with_copied_corners(std::move(soup), n, random);
    const Tolerances tolerances = resolve_tolerances({}, box_of(soup));
    const RepairState state(track_mesh(soup), tolerances);
    const DefectInventory listed =
        list_defective_in_file(state, tolerances, {.equal_points = EqualPoints::Merge});
    const RepairState merged(track_mesh(with_equal_points_merged(soup)), tolerances);
    const DefectInventory anew =
        list_defective(merged.tracked(), merged.mesh(), tolerances, UnweldedPairs::Count);
    EXPECT_GE(anew.count(CountedDefect::IntersectingPairs), 50U);
    EXPECT_EQ(listed.counts, anew.counts) << n;
    EXPECT_EQ(listed.elements, anew.elements) << n;
    EXPECT_EQ(listed.is_yes, anew.is_yes) << n;
  }
}

}  // namespace
}  // namespace meshalyzer
