#include "meshalyzer/io/read.h"
#include "meshalyzer/repair/fix_defects.h"
#include "meshalyzer/topology/border.h"
#include "support/effort.h"
#include "unit/repair/weld/weld_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace meshalyzer {
namespace {

constexpr std::array kLengths{1e-8, 1e-6, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2};

/// Welds borders, and nothing else, within a share of the diagonal.
std::size_t border_edges_left(const Soup& soup, double share) {
  RepairOptions options;
  options.fixes = {};
  options.max_deviation = {.value = 0.1};
  options.weld_within = share * box_of(soup).diagonal().norm();
  const RepairResult result = fix_defects(soup, options);
  return find_border_edges(build(result.meshes.front().tracked.soup)).size();
}

void expect_larger_lengths_close_no_less(const Soup& soup) {
  std::size_t least = find_border_edges(build(soup)).size();
  for (const double length : kLengths) {
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

TEST(WeldBorders, LargerLengthClosesNoLessOfARealMesh) {
  // Welded within 1e-3 of the diagonal at once it keeps more border edges than within 1e-8.
  const std::string file = MESHALYZER_CORPUS "/neuropil/heal_a003.mesh";
  if (!std::filesystem::is_regular_file(file)) GTEST_SKIP() << "no corpus";
  expect_larger_lengths_close_no_less(read_mesh(file));
}

}  // namespace
}  // namespace meshalyzer
