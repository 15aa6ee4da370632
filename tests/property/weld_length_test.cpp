#include "meshalyzer/io/read.h"
#include "meshalyzer/repair/fix_defects.h"
#include "meshalyzer/topology/border.h"
#include "support/effort.h"
#include "support/same_soup.h"
#include "unit/repair/weld/weld_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::array kLengths{1e-8, 1e-6, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2};
constexpr std::array kMoreLengths{1e-8, 1e-6, 1e-5, 4e-5, 1e-4, 2e-4, 3e-4,
                                  6e-4, 1e-3, 2e-3, 3e-3, 4e-3, 6e-3, 1e-2};

/// Welds borders, and nothing else, within a length.
Soup welded_within(const Soup& soup, double length) {
  RepairOptions options;
  options.fixes = {};
  options.max_deviation = {.value = 0.1};
  options.weld_within = length;
  return fix_defects(soup, options).meshes.front().tracked.soup;
}

/// Does the same within a share of the diagonal.
Soup welded_within_share(const Soup& soup, double share) {
  return welded_within(soup, share * box_of(soup).diagonal().norm());
}

void expect_larger_lengths_close_no_less(const Soup& soup,
                                         std::span<const double> lengths = kLengths) {
  std::size_t least = find_border_edges(build(soup)).size();
  for (const double length : lengths) {
    const std::size_t left = find_border_edges(build(welded_within_share(soup, length))).size();
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

/// How a surface falls into parts that have no vertex in common.
enum class Tear : std::uint8_t {
  /// Every face is a part.
  EveryFace,
  /// A quarter of the faces are parts, and the rest is one.
  SingleFaces,
  /// The faces are two to thirteen parts at random.
  Patches,
};

/// Returns the number of the part of each face: of the random centres of patches, the one nearest
/// to its first corner.
std::vector<std::size_t> parts_of(const Soup& soup, Tear tear, std::mt19937& random) {
  std::vector<std::size_t> parts(soup.n_faces(), 0);
  std::vector<Vec3> centres;
  const std::size_t n_centres = 2 + random() % 12;
  for (std::size_t i = 0; i < n_centres; ++i) {
    centres.push_back(soup.positions[random() % soup.n_vertices()]);
  }
  for (std::size_t f = 0; f < parts.size(); ++f) {
    if (tear == Tear::EveryFace) parts[f] = f;
    if (tear == Tear::SingleFaces) parts[f] = random() % 4 == 0 ? f + 1 : 0;
    if (tear != Tear::Patches) continue;
    const Vec3& p = soup.positions[soup.triangles[f][0]];
    const auto nearer = [&](const Vec3& a, const Vec3& b) {
      return (a - p).squaredNorm() < (b - p).squaredNorm();
    };
    const auto nearest = std::min_element(centres.begin(), centres.end(), nearer);
    parts[f] = static_cast<std::size_t>(nearest - centres.begin());
  }
  return parts;
}

/// Tears a surface into parts, and moves every coordinate of vertices on several parts by up to
/// `amount` either way.
Soup torn(const Soup& soup, std::span<const std::size_t> parts, double amount,
          std::mt19937& random) {
  std::map<std::pair<Index, std::size_t>, Index> copies;
  std::vector<std::size_t> n_copies(soup.n_vertices(), 0);
  std::vector<Index> origin;
  std::vector<Triangle> triangles = soup.triangles;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (Index& v : triangles[f]) {
      const auto [copy, is_new] = copies.emplace(std::pair(v, parts[f]), origin.size());
      if (is_new) {
        ++n_copies[v];
        origin.push_back(v);
      }
      v = copy->second;
    }
  }
  std::vector<Vec3> positions;
  for (const Index v : origin) {
    Vec3& p = positions.emplace_back(soup.positions[v]);
    if (n_copies[v] < 2) continue;
    for (double& x : p) x += amount * (2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0);
  }
  return shapes::make(std::move(positions), std::move(triangles));
}

struct TornMesh {
  Soup soup;
  /// The largest amount by which a coordinate was moved, as a share of the diagonal.
  double jitter = 0.0;
};

/// Returns a surface that was torn apart at random, by jitter from 1e-4 to 1e-2 of its size.
TornMesh torn_mesh(std::uint32_t seed) {
  std::mt19937 random(seed);
  const std::array shapes{shapes::icosphere(1), shapes::uv_sphere(6, 8), shapes::genus_block(1),
                          shapes::torus(2, 1, 10, 6), shapes::grid(10, 6)};
  const Soup& shape = shapes[random() % shapes.size()];
  const auto tear = static_cast<Tear>(random() % 3);
  const double jitter = std::pow(10.0, -4.0 + 2.0 * static_cast<double>(random()) / 4294967295.0);
  const double amount = jitter * box_of(shape).diagonal().norm();
  return {.soup = torn(shape, parts_of(shape, tear, random), amount, random), .jitter = jitter};
}

TEST(WeldBorders, LargerLengthClosesNoLessWhereGapsAreAsLong) {
  // Copies of a vertex are up to sqrt(12) times the jitter apart, so that each of these lengths is
  // longer than some of the gaps and shorter than others, but for the last one.
  test::Effort share;
  for (std::uint32_t seed = 1; seed <= 15; ++seed) {
    if (!share.runs_next()) continue;
    SCOPED_TRACE(seed);
    const TornMesh torn = torn_mesh(seed);
    std::vector<double> lengths;
    for (const double factor : {0.3, 0.6, 0.9, 1.1, 1.25, 1.4, 1.6, 1.8, 2.1, 2.4, 2.8, 3.6}) {
      lengths.push_back(factor * torn.jitter);
    }
    expect_larger_lengths_close_no_less(torn.soup, lengths);
  }
}

TEST(WeldBorders, NoLengthMakesACountWorse) {
  test::Effort share;
  for (std::uint32_t seed = 101; seed <= 110; ++seed) {
    if (!share.runs_next()) continue;
    const TornMesh torn = torn_mesh(seed);
    const SeamTopology before = seam_topology_of(torn.soup);
    for (const double factor : {0.6, 1.2, 1.7, 2.4, 3.6}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << factor << " of the jitter");
      const SeamTopology after =
          seam_topology_of(welded_within_share(torn.soup, factor * torn.jitter));
      EXPECT_LE(after.border_edges, before.border_edges);
      EXPECT_LE(after.non_manifold_edges, before.non_manifold_edges);
      EXPECT_LE(after.non_manifold_vertices, before.non_manifold_vertices);
      EXPECT_LE(after.flipped_edges, before.flipped_edges);
      EXPECT_LE(after.duplicate_faces, before.duplicate_faces);
    }
  }
}

TEST(WeldBorders, WeldingAgainChangesNothing) {
  test::Effort share;
  for (std::uint32_t seed = 201; seed <= 210; ++seed) {
    if (!share.runs_next()) continue;
    SCOPED_TRACE(seed);
    const TornMesh torn = torn_mesh(seed);
    const double length = 1.7 * torn.jitter * box_of(torn.soup).diagonal().norm();
    const Soup once = welded_within(torn.soup, length);
    EXPECT_TRUE(same_soup(welded_within(once, length), once));
  }
}

TEST(WeldBorders, GapOfTheLengthIsClosedBesideOneThatIsLittleLonger) {
  // The second pair of faces is far from the first one, so that it does not matter there.
  const double gap = 0.01;
  const Soup wider = shapes::translated(two_triangles_apart(1.0001 * gap), Vec3(5, 0, 0));
  const Soup both = shapes::merged(two_triangles_apart(gap), wider);
  // Each of the four faces has three border edges, two of which become one.
  EXPECT_EQ(find_border_edges(build(welded_within(both, gap))).size(), 12U - 2U);
  EXPECT_EQ(find_border_edges(build(welded_within(both, 1.001 * gap))).size(), 12U - 4U);
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
