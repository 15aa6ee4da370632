#include "meshalyzer/io/read.h"
#include "meshalyzer/repair/fix_defects.h"
#include "meshalyzer/topology/border.h"
#include "support/effort.h"
#include "unit/repair/weld/weld_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::array kLengths{1e-8, 1e-6, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2};
constexpr std::array kMoreLengths{1e-8, 1e-6, 1e-5, 4e-5, 1e-4, 2e-4, 3e-4,
                                  6e-4, 1e-3, 2e-3, 3e-3, 4e-3, 6e-3, 1e-2};

/// Welds borders, and nothing else, within a share of the diagonal.
std::size_t border_edges_left(const Soup& soup, double share) {
  RepairOptions options;
  options.fixes = {};
  options.max_deviation = {.value = 0.1};
  options.weld_within = share * box_of(soup).diagonal().norm();
  const RepairResult result = fix_defects(soup, options);
  return find_border_edges(build(result.meshes.front().tracked.soup)).size();
}

void expect_larger_lengths_close_no_less(const Soup& soup,
                                         std::span<const double> lengths = kLengths) {
  std::size_t least = find_border_edges(build(soup)).size();
  for (const double length : lengths) {
    const std::size_t left = border_edges_left(soup, length);
    EXPECT_LE(left, least) << "within " << length << " of the diagonal";
    least = std::min(least, left);
  }
}

TEST(WeldBorders, LargerLengthClosesNoLessOfTornMeshes) {
  std::uint32_t seed = 1;
  test::Effort share;
  for (const Soup& shape : {shapes::icosphere(2), shapes::uv_sphere(8, 12), shapes::genus_block(2),
                            shapes::torus(2, 1, 12, 8)}) {
    for (const double jitter : {1e-6, 1e-4, 3e-3}) {
      if (!share.runs_next()) continue;
      SCOPED_TRACE(seed);
      expect_larger_lengths_close_no_less(jittered(unwelded(shape), jitter, seed++));
    }
  }
}

/// Returns ascending places strictly between 0 and 1, near a lattice of 40, about five in all. On
/// average half of them are beside the lattice, by lengths of all the sizes that are welded, so
/// that vertices on the two sides of a crack may be about as near to each other.
std::vector<double> random_places(std::mt19937& random) {
  std::vector<double> places;
  for (int i = 1; i < 40; ++i) {
    const double nearby = std::pow(10.0, -2.0 - static_cast<double>(random() % 50) / 10.0);
    if (random() % 8 == 0) places.push_back(i / 40.0 + (random() % 2 == 0 ? 0.0 : nearby));
  }
  return places;
}

TEST(WeldBorders, LargerLengthClosesNoLessOfInterleavedCracks) {
  std::mt19937 random(23);
  test::Effort share;
  for (int trial = 0; trial < 60; ++trial) {
    if (!share.runs_next()) continue;
    SCOPED_TRACE(trial);
    Soup cracks;
    for (int i = 0; i < 4; ++i) {
      const double gap = std::pow(10.0, -2.0 - static_cast<double>(random() % 50) / 10.0);
      const std::vector<double> above = random_places(random);
      const Soup crack = interleaved_crack(gap, above, random_places(random));
      cracks = shapes::merged(cracks, shapes::translated(crack, Vec3(0.0, 0.0, 0.3 * i)));
    }
    const auto seed = static_cast<std::uint32_t>(random());
    expect_larger_lengths_close_no_less(jittered(cracks, trial % 3 == 0 ? 0.0 : 1e-5, seed),
                                        kMoreLengths);
  }
}

TEST(WeldBorders, LargerLengthClosesNoLessOfARealMesh) {
  // Welded within 1e-3 of the diagonal at once it keeps more border edges than within 1e-8.
  const std::string file = MESHALYZER_CORPUS "/neuropil/heal_a003.mesh";
  if (!std::filesystem::is_regular_file(file)) GTEST_SKIP() << "no corpus";
  expect_larger_lengths_close_no_less(read_mesh(file));
}

}  // namespace
}  // namespace meshalyzer
