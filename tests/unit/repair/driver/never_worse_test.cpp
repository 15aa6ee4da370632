#include "meshalyzer/mesh/used_box.h"
#include "meshalyzer/repair/driver/internal/worsening.h"
#include "meshalyzer/repair/fix_defects.h"
#include "support/same_soup.h"
#include "support/shapes.h"
#include "unit/repair/repaired_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace meshalyzer {
namespace {

DefectInventory with_counts(std::size_t non_manifold, std::size_t borders, std::size_t pairs) {
  DefectInventory inventory;
  inventory.counts[static_cast<std::size_t>(CountedDefect::NonManifoldEdges)] = non_manifold;
  inventory.counts[static_cast<std::size_t>(CountedDefect::BorderEdges)] = borders;
  inventory.counts[static_cast<std::size_t>(CountedDefect::IntersectingPairs)] = pairs;
  return inventory;
}

TEST(FindWorsening, FallingCountsAreNotWorse) {
  EXPECT_TRUE(find_worsening(with_counts(2, 6, 3), with_counts(1, 6, 0)).empty());
}

TEST(FindWorsening, OneBorderEdgeForEachNonManifoldEdgeIsExcepted) {
  EXPECT_TRUE(find_worsening(with_counts(2, 6, 0), with_counts(0, 8, 0)).empty());
}

TEST(FindWorsening, MoreBorderEdgesThanPartedEdgesAreWorse) {
  EXPECT_EQ(find_worsening(with_counts(2, 6, 0), with_counts(0, 9, 0)).kinds,
            std::vector{CountedDefect::BorderEdges});
}

TEST(FindWorsening, BorderEdgesOfCutSheetsAreExceptedIfPairsFall) {
  DefectInventory after = with_counts(0, 10, 2);
  after.n_borders_of_cut_sheets = 4;
  EXPECT_TRUE(find_worsening(with_counts(0, 6, 3), after).empty());
  EXPECT_EQ(find_worsening(with_counts(0, 5, 3), after).kinds,
            std::vector{CountedDefect::BorderEdges});
  EXPECT_EQ(find_worsening(with_counts(0, 6, 2), after).kinds,
            std::vector{CountedDefect::BorderEdges});
}

TEST(FindWorsening, SlitEdgesOfCutSheetsAreExceptedIfPairsFall) {
  DefectInventory after = with_counts(0, 6, 2);
  after.counts[static_cast<std::size_t>(CountedDefect::SlitEdges)] = 4;
  EXPECT_EQ(find_worsening(with_counts(0, 6, 3), after).kinds,
            std::vector{CountedDefect::SlitEdges});
  after.n_slits_of_cut_sheets = 4;
  EXPECT_TRUE(find_worsening(with_counts(0, 6, 3), after).empty());
  EXPECT_EQ(find_worsening(with_counts(0, 6, 2), after).kinds,
            std::vector{CountedDefect::SlitEdges});
}

TEST(ListDefective, SlitEdgesOnBothSidesOfACutAreThoseOfACutSheet) {
  Soup halves = shapes::grid(2, 1);
  halves = shapes::merged(halves, shapes::translated(halves, {2, 0, 0}));
  TrackedMesh tracked = track_mesh(halves);
  const PreparedMesh mesh(halves);
  const Tolerances tolerances = resolve_tolerances({}, used_box(halves));
  const auto n_of_cuts = [&] {
    return list_defective(tracked, mesh, tolerances, UnweldedPairs::Count).n_slits_of_cut_sheets;
  };
  EXPECT_EQ(n_of_cuts(), 0U);
  // The right end of the left half.
  tracked.sheet_cuts = {2};
  EXPECT_EQ(n_of_cuts(), 2U);
}

TEST(FindWorsening, IntersectionsAreWorseWhateverElseFalls) {
  EXPECT_EQ(find_worsening(with_counts(2, 6, 3), with_counts(0, 0, 4)).kinds,
            std::vector{CountedDefect::IntersectingPairs});
}

TEST(FindWorsening, ClosedMeshMustStayClosedWhateverIsParted) {
  DefectInventory before = with_counts(1, 0, 0);
  before.is_yes[static_cast<std::size_t>(Attribute::Closed)] = true;
  const Worsening worsening = find_worsening(before, with_counts(0, 1, 0));
  EXPECT_EQ(worsening.lost, std::vector{Attribute::Closed});
  EXPECT_EQ(worsening.kinds, std::vector{CountedDefect::BorderEdges});
}

TEST(NeverWorse, ClosedPillowThatIsAllThereIsStays) {
  const RepairResult result = fix_defects(shapes::pillow());
  EXPECT_TRUE(same_soup(result.meshes.front().tracked.soup, shapes::pillow()));
  EXPECT_TRUE(result.rises.empty());
}

TEST(NeverWorse, BorderEdgeThatAThirdFaceLeavesIsNamed) {
  // Three faces at one edge and two borders each: parted, one of the three has a border there too.
  const RepairResult result = fix_defects(shapes::fan_of_three());
  ASSERT_EQ(result.rises.size(), 1U);
  EXPECT_EQ(result.rises[0].kind, CountedDefect::BorderEdges);
  EXPECT_EQ(result.rises[0].before, 6U);
  EXPECT_EQ(result.rises[0].after, 7U);
}

TEST(NeverWorse, BorderEdgeThatIsClosedInTheEndIsNotNamed) {
  // As above, with two of the faces in one plane: the passes leave the border edge, and then the
  // sheets become thin solids.
  const Soup soup = shapes::make({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
                                 {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  RepairOptions options;
  options.solid = true;
  options.guarantee = true;
  options.fill.sheets = FillSheets::Yes;
  const RepairResult result = fix_defects(soup, options);
  EXPECT_TRUE(is_good(result.meshes.front().tracked.soup));
  EXPECT_TRUE(result.rises.empty());
}

TEST(NeverWorse, VertexWhoseCopiesCannotBePartedIsNotSplit) {
  // Without any deviation the copies would stay at one place, where their faces touch.
  RepairOptions options;
  options.max_deviation = {.value = 0.0, .unit = Deviation::Unit::Length};
  const Soup soup = shapes::two_tetrahedra_sharing_vertex();
  const RepairResult result = fix_defects(soup, options);
  EXPECT_TRUE(same_soup(result.meshes.front().tracked.soup, soup));
  EXPECT_TRUE(result.log.steps.empty());
  EXPECT_TRUE(std::any_of(result.log.refusals.begin(), result.log.refusals.end(),
                          [](const LoggedRefusal& refusal) {
                            return refusal.pass == "split vertices" &&
                                   refusal.reason.find("final mesh worse") != std::string::npos;
                          }));
}

TEST(NeverWorse, ContactThatIsAskedForIsNotCounted) {
  RepairOptions options;
  options.contact = Contact::Keep;
  const RepairResult result = fix_defects(shapes::two_tetrahedra_sharing_vertex(), options);
  // 7 vertices, and a copy of the common one.
  EXPECT_EQ(result.meshes.front().tracked.soup.n_vertices(), 8U);
  EXPECT_TRUE(result.rises.empty());
}

TEST(NeverWorse, MeshMayBeTurnedInwardWhereThatIsAskedFor) {
  RepairOptions options;
  options.fixes = {};
  options.turn = Turn::Everything;
  const RepairResult result = fix_defects(shapes::cube(), options);
  EXPECT_EQ(result.log.steps.size(), 1U);
}

}  // namespace
}  // namespace meshalyzer
