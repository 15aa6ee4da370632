#include "meshalyzer/repair/internal/pass_memory.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/split/internal/contact_places.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"
#include "unit/repair/cell_complex.h"
#include "unit/repair/split/split_passes.h"
#include "unit/repair/voxel_solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

/// The longest way that any vertex has gone.
double largest_move(const Soup& before, const Soup& after) {
  double largest = 0.0;
  for (std::size_t v = 0; v < before.n_vertices(); ++v) {
    largest = std::max(largest, (after.positions[v] - before.positions[v]).norm());
  }
  return largest;
}

std::vector<Index> moved_vertices(const Soup& before, const Soup& after) {
  std::vector<Index> moved;
  for (Index v = 0; v < before.n_vertices(); ++v) {
    if (before.positions[v] != after.positions[v]) moved.push_back(v);
  }
  return moved;
}

/// Random cubes of a block, as many as a percentage.
VoxelSolid random_solid(std::uint32_t seed, int size) {
  std::mt19937 random(seed);
  VoxelSolid solid({size, size, size});
  const auto percentage = 15 + random() % 70;
  solid.fill({0, 0, 0});
  for (int x = 0; x < size; ++x) {
    for (int y = 0; y < size; ++y) {
      for (int z = 0; z < size; ++z) {
        if (random() % 100 < percentage) solid.fill({x, y, z});
      }
    }
  }
  return solid;
}

TEST(PartContacts, MeshesWithoutContactAreLeft) {
  // Crossing cubes intersect, but not because of copies in one place.
  const Soup crossing =
      shapes::merged(shapes::cube(), shapes::translated(shapes::cube(), {0.5, 0.25, 0.125}));
  for (const Soup& soup : {shapes::cube(), Soup{}, crossing, shapes::pillow(),
                           shapes::nested_cubes(shapes::InnerShell::Cavity)}) {
    EXPECT_TRUE(same_soup(run_pass(soup, part_contacts).tracked.soup, soup));
  }
}

TEST(PartContacts, CopyOfAPinchedVertexMovesByAFewRoundings) {
  const Soup split_up = split(shapes::two_tetrahedra_sharing_vertex()).tracked.soup;
  ASSERT_GT(n_intersecting_pairs(split_up), 0U);
  const PassRun run = run_pass(split_up, part_contacts);
  EXPECT_EQ(n_intersecting_pairs(run.tracked.soup), 0U);
  EXPECT_EQ(run.operations, 1U);
  EXPECT_EQ(run.rounds, 1U);
  // The copy is the last vertex. A step of one epsilon along each axis is enough.
  EXPECT_EQ(moved_vertices(split_up, run.tracked.soup), std::vector<Index>{7});
  EXPECT_LE(largest_move(split_up, run.tracked.soup), 2 * std::numeric_limits<double>::epsilon());
}

TEST(PartContacts, BothEndsOfASplitEdgeMoveAsOne) {
  const Soup split_up = split(shapes::two_tetrahedra_sharing_edge()).tracked.soup;
  const PassRun run = run_pass(split_up, part_contacts);
  EXPECT_EQ(n_intersecting_pairs(run.tracked.soup), 0U);
  EXPECT_EQ(run.operations, 1U);
  EXPECT_EQ(moved_vertices(split_up, run.tracked.soup), (std::vector<Index>{6, 7}));
}

TEST(PartContacts, FacesThatLieOnEachOtherAreParted) {
  const PassRun run = split_and_part(shapes::two_tetrahedra_sharing_face());
  EXPECT_EQ(n_intersecting_pairs(run.tracked.soup), 0U);
}

TEST(PartContacts, TipInAPitIsDrawnOut) {
  // A pyramid stands on its tip in the bottom of a pit like itself but wider: the solid round the
  // pit could give way too, downwards.
  Soup soup = shapes::make({{0, 0, 0},
                            {1, 0, 1},
                            {-1, 1, 1},
                            {-1, -1, 1},
                            {0, 0, -3},
                            {5, 0, 1},
                            {-5, 5, 1},
                            {-5, -5, 1}},
                           {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}});
  const std::vector<Triangle> pit{{0, 5, 6}, {0, 6, 7}, {0, 7, 5}, {4, 6, 5}, {4, 7, 6}, {4, 5, 7}};
  soup.triangles.insert(soup.triangles.end(), pit.begin(), pit.end());
  const PassRun run = split_and_part(soup);
  EXPECT_TRUE(is_manifold(run.tracked.soup));
  EXPECT_EQ(n_intersecting_pairs(run.tracked.soup), 0U);
  EXPECT_TRUE(run.refused.empty());
}

TEST(PartContacts, FinIsMovedOffTheSurface) {
  const PassRun run = split_and_part(shapes::fan_of_three());
  EXPECT_EQ(n_intersecting_pairs(run.tracked.soup), 0U);
}

TEST(PartContacts, ThinFacesInWhoseBoxesThousandsLieAreParted) {
  // Two spikes along a diagonal touch with their tips.
  const double far = 100.0;
  Soup soup = shapes::make({{0, 0, 0},
                            {far, far, far},
                            {far + 1, far, far},
                            {far, far + 1, far},
                            {-far, -far, -far},
                            {-far - 1, -far, -far},
                            {-far, -far - 1, -far}},
                           {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}});
  const std::vector<Triangle> other{{0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}};
  soup.triangles.insert(soup.triangles.end(), other.begin(), other.end());
  // Beside the spikes, within the boxes of their sides, lie 8,000 faces.
  const Soup small = shapes::scaled(shapes::tetrahedron(), 0.5);
  for (int x = 10; x < 20; ++x) {
    for (int y = 71; y < 81; ++y) {
      for (int z = 40; z < 50; ++z) {
        const Vec3 corner(x, y, z);
        soup = shapes::merged(soup, shapes::translated(small, corner));
        soup = shapes::merged(soup, shapes::translated(small, -corner));
      }
    }
  }
  const PassRun run = split_and_part(soup);
  EXPECT_EQ(n_intersecting_pairs(run.tracked.soup), 0U);
  EXPECT_TRUE(run.refused.empty());
}

TEST(PartContacts, SeamsThatCanBeWeldedAreLeft) {
  // Each face of the cube has vertices of its own.
  Soup soup;
  const Soup cube = shapes::cube();
  for (const Triangle& t : cube.triangles) {
    const auto first = static_cast<Index>(soup.positions.size());
    for (const Index v : t) soup.positions.push_back(cube.positions[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  ASSERT_GT(n_intersecting_pairs(soup), 0U);
  EXPECT_TRUE(same_soup(run_pass(soup, part_contacts).tracked.soup, soup));
}

TEST(PartContacts, WhereOneCopyIsFixedTheOtherMoves) {
  const Soup split_up = split(shapes::two_tetrahedra_sharing_vertex()).tracked.soup;
  const PassRun run = run_pass(split_up, part_contacts, body_limits(split_up, {7}));
  EXPECT_EQ(moved_vertices(split_up, run.tracked.soup), std::vector<Index>{0});
  EXPECT_EQ(n_intersecting_pairs(run.tracked.soup), 0U);
}

TEST(PartContacts, WhereAllAreFixedItIsRefused) {
  const Soup split_up = split(shapes::two_tetrahedra_sharing_vertex()).tracked.soup;
  const PassRun run = run_pass(split_up, part_contacts, body_limits(split_up, {0, 7}));
  EXPECT_TRUE(same_soup(run.tracked.soup, split_up));
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(run.refused[0].vertex, 0U);
}

TEST(PartContacts, NoStepWithinTheDeviationIsRefused) {
  const Soup split_up = split(shapes::two_tetrahedra_sharing_vertex()).tracked.soup;
  RepairLimits limits = wide_limits(split_up);
  limits.max_deviation = 1e-17;
  const PassRun run = run_pass(split_up, part_contacts, limits);
  EXPECT_TRUE(same_soup(run.tracked.soup, split_up));
  EXPECT_EQ(run.refused.size(), 1U);
}

/// Tetrahedra that touch with their tips, in a heap of thousands of faces.
Soup tips_in_a_heap() {
  Soup soup = split(shapes::two_tetrahedra_sharing_vertex()).tracked.soup;
  // Each of them meets two of the three faces at a tip.
  for (int i = -2500; i < 2500; ++i) {
    const double x = 1e-4 * (i + 0.5);
    const auto first = static_cast<Index>(soup.n_vertices());
    soup.positions.insert(soup.positions.end(), {{x, -1, -1}, {x, 1, -1}, {x, 0, 2}});
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

TEST(PartContacts, PlacesThatHaveFailedBeforeComeLast) {
  PassMemory memory;
  const auto refused = [&](const Soup& soup) {
    std::vector<Index> vertices;
    for (const Refusal& refusal : run_pass(soup, remembering(memory, part_contacts)).refused) {
      vertices.push_back(refusal.vertex);
    }
    return vertices;
  };
  const Soup heap = tips_in_a_heap();
  const Soup one = shapes::merged(heap, shapes::translated(shapes::cube(), {8, 0, 0}));
  const Soup two = shapes::merged(one, shapes::translated(heap, {4, 0, 0}));
  EXPECT_EQ(refused(one), std::vector<Index>{0});
  EXPECT_EQ(refused(two), (std::vector<Index>{static_cast<Index>(one.n_vertices()), 0}));
}

TEST(PartContacts, LikewiseFarFromTheOriginAndForAnySize) {
  const Soup two = shapes::two_tetrahedra_sharing_edge();
  for (const Soup& soup : {shapes::translated(two, {1e6, -3e5, 7e5}), shapes::scaled(two, 1e150),
                           shapes::scaled(two, 1e-150), shapes::scaled(two, 1e300)}) {
    EXPECT_EQ(n_intersecting_pairs(split_and_part(soup).tracked.soup), 0U);
  }
}

TEST(PartContacts, AnySolidOfCubesComesOutCleanWithItsPartsApart) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const VoxelSolid solid = random_solid(seed, 1 + static_cast<int>(seed % 5));
    const Soup soup =
        shapes::shuffled_faces(shapes::renumbered_vertices(solid.surface(), seed), seed);
    const PassRun run = split_and_part(soup);
    const Soup& result = run.tracked.soup;
    EXPECT_TRUE(is_manifold(result));
    EXPECT_EQ(n_border_edges(result), 0U);
    EXPECT_EQ(build(result).side.flipped_edges.size(), 0U);
    EXPECT_EQ(n_intersecting_pairs(result), 0U);
    EXPECT_TRUE(run.refused.empty());
    EXPECT_LE(run.rounds, 1U);

    // Outer shells have a positive volume, walls of cavities a negative one.
    const std::vector<double> all = volumes(result);
    const auto n_outer = std::count_if(all.begin(), all.end(), [](double v) { return v > 0; });
    EXPECT_EQ(static_cast<std::size_t>(n_outer), solid.n_parts());
    double volume = 0.0;
    for (const double v : all) volume += v;
    EXPECT_NEAR(volume, static_cast<double>(solid.full_cells().size()), 1e-9);

    // Faces keep their order, and all vertices but those where parts touched their places.
    const std::vector<Index>& broken = build(soup).side.non_manifold_vertices;
    for (const Index v : moved_vertices(soup, result)) {
      EXPECT_TRUE(std::binary_search(broken.begin(), broken.end(), v));
    }
    EXPECT_LT(largest_move(soup, result), 1e-12);
    EXPECT_TRUE(same_soup(split_and_part(result).tracked.soup, result));
  }
}

TEST(PartContacts, PlacesAreTriedOnceMoreBeforeOthersThatTookTheirRoom) {
  // In each of these, places fail whose neighbours were moved before them.
  for (const unsigned seed : {17U, 22U, 59U, 195U, 216U}) {
    std::mt19937 random(seed);
    const PassRun run = split_and_part(grained_complex(6, 6, random).faces().soup);
    EXPECT_TRUE(run.refused.empty()) << seed;
    EXPECT_EQ(n_intersecting_pairs(run.tracked.soup), 0U) << seed;
  }
}

/// A square with two edges in a row through its middle vertex; a sheet above these edges, and one
/// below, each with vertices of its own.
Soup sheets_on_both_sides_of_a_square() {
  Soup halves;
  for (const double side : {1.0, -1.0}) {
    const auto first = static_cast<Index>(halves.n_vertices());
    for (const double x : {0.0, 1.0, 2.0}) halves.positions.emplace_back(x, 1.0, 0.0);
    halves.positions.emplace_back(1.0, 1.0, side);
    halves.triangles.push_back({first, first + 1, first + 3});
    halves.triangles.push_back({first + 1, first + 2, first + 3});
  }
  return shapes::merged(shapes::grid(2, 2), halves);
}

TEST(FindContactPlaces, SidesOfACutSheetMoveApart) {
  TrackedMesh tracked = track_mesh(sheets_on_both_sides_of_a_square());
  const PreparedMesh mesh(tracked.soup);
  // Vertex 4 is in the middle; welding would join 10 and 14 where nothing was cut.
  const auto units_in_the_middle = [&] {
    const std::vector<ContactPlace> places = find_contact_places(tracked, mesh).places;
    const auto middle = std::find_if(places.begin(), places.end(), [](const ContactPlace& place) {
      return place.units.front().front() == 4;
    });
    return middle == places.end() ? std::vector<std::vector<Index>>{} : middle->units;
  };
  EXPECT_EQ(units_in_the_middle(), (std::vector<std::vector<Index>>{{4}, {10, 14}}));
  tracked.sheet_cuts = {3, 4, 5, 9, 10, 11, 13, 14, 15};
  EXPECT_EQ(units_in_the_middle(), (std::vector<std::vector<Index>>{{4}, {10}, {14}}));
}

}  // namespace
}  // namespace meshalyzer
