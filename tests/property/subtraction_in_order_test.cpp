#include "meshalyzer/boolean/combine_solids.h"
#include "meshalyzer/boolean/part_from.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/mutual_intersection.h"
#include "support/boolean_results.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

using test::combined;
using test::places_of;
using test::rotated;
using test::verdict_on;
using test::volume_of;

/// Each mesh without those before it, moved off them.
std::vector<Soup> subtracted_in_order(const std::vector<Soup>& meshes) {
  std::vector<Soup> results;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    std::vector<Soup> some{meshes[i]};
    some.insert(some.end(), meshes.begin(), meshes.begin() + static_cast<std::ptrdiff_t>(i));
    const Soup all = concatenate(some);
    const Operands operands = operands_of(all, some);
    CombinedSolid solid = combine_solids(operands, difference_rule());
    const PartedVertices parted = part_from(solid, operands, concatenate(results), 1e-3);
    EXPECT_EQ(parted.n_pairs_left, 0U) << i;
    EXPECT_LT(parted.largest_move, 1e-9) << i;
    for (std::size_t k = 0; k < parted.vertices.size(); ++k) {
      solid.positions[parted.vertices[k]] = parted.positions[k];
    }
    results.push_back(as_soup(solid));
  }
  return results;
}

void expect_disjoint(const std::vector<Soup>& meshes) {
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const CutMesh cut = build(meshes[i]);
    const FaceTree tree(cut);
    for (std::size_t j = 0; j < i; ++j) {
      const CutMesh other = build(meshes[j]);
      EXPECT_TRUE(find_intersections(cut, tree, other, FaceTree(other)).empty()) << i << ' ' << j;
    }
  }
}

TEST(SubtractionInOrder, SolidsSubtractedInOrderAreDisjointAndTogetherTheirUnion) {
  std::vector<Soup> meshes;
  for (int i = 0; i < 7; ++i) {
    const Soup mesh = i % 2 == 0 ? shapes::icosphere(2) : shapes::torus(0.9, 0.3, 24, 10);
    const Vec3 by(0.5 * std::sin(2.0 * i), 0.6 * std::cos(3.0 * i), 0.7 * std::sin(5.0 * i));
    meshes.push_back(shapes::translated(rotated(mesh, 0.7 * i, {1.0, 0.3 * i, -0.2}), by));
  }
  const std::vector<Soup> results = subtracted_in_order(meshes);
  double sum = 0.0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    EXPECT_EQ(verdict_on(results[i]), "good") << i;
    sum += volume_of(results[i]);
  }
  expect_disjoint(results);
  EXPECT_EQ(places_of(results[0]), places_of(meshes[0]));
  EXPECT_NEAR(sum, volume_of(combined(meshes, union_rule())), 1e-7);
}

/// Every mesh of the corpus' set, moved towards the first one by a share of the distance.
std::vector<Soup> neuropil(double share) {
  std::vector<Soup> meshes;
  std::vector<std::string> paths;
  const std::filesystem::path folder = std::filesystem::path(MESHALYZER_CORPUS) / "neuropil_set";
  if (!std::filesystem::exists(folder)) return {};
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  Vec3 first = Vec3::Zero();
  for (const std::string& path : paths) {
    Soup mesh = read_mesh(path);
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : mesh.positions) middle += p / static_cast<double>(mesh.n_vertices());
    if (meshes.empty()) first = middle;
    meshes.push_back(shapes::translated(std::move(mesh), share * (first - middle)));
  }
  return meshes;
}

TEST(SubtractionInOrder, NeuropilIsMadeDisjointInOrder) {
  const std::vector<Soup> apart = neuropil(0.0);
  if (apart.empty()) GTEST_SKIP() << "no corpus at " << MESHALYZER_CORPUS;
  // It is disjoint as it is, and stays.
  const std::vector<Soup> same = subtracted_in_order(apart);
  for (std::size_t i = 0; i < apart.size(); ++i) EXPECT_EQ(places_of(same[i]), places_of(apart[i]));
  for (const double share : {0.7, 0.9}) {
    const std::vector<Soup> results = subtracted_in_order(neuropil(share));
    for (const Soup& result : results) {
      // One may be inside of those before it.
      if (result.triangles.empty()) continue;
      EXPECT_EQ(verdict_on(result), "good") << share;
    }
    expect_disjoint(results);
  }
}

TEST(SubtractionInOrder, CubesThatOnlyTouchArePartedByAFewUnitsInTheLastPlace) {
  const std::vector<Soup> results = subtracted_in_order(
      {shapes::cube(2), shapes::cube(2, {2, 0, 0}), shapes::cube(1, {1, 2, 2})});
  EXPECT_EQ(places_of(results[0]), places_of(shapes::cube(2)));
  for (const Soup& result : results) EXPECT_EQ(verdict_on(result), "good");
}

}  // namespace
}  // namespace meshalyzer
