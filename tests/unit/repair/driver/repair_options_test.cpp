#include "meshalyzer/repair/fix_defects.h"
#include "support/same_soup.h"
#include "support/shapes.h"
#include "unit/repair/repaired_meshes.h"
#include "unit/repair/weld/weld_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

using enum DefectCode;

TEST(RepairOptions, NumberingStaysUnlessAskedFor) {
  Soup soup = cube_with_ids();
  soup.triangles.insert(soup.triangles.begin() + 3, soup.triangles[1]);
  soup.face_ids.named = {11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23};
  const RepairResult kept = fix_defects(soup);
  // The fourth record is gone, and its id is free.
  EXPECT_EQ(only_mesh(kept).face_ids.named,
            (std::vector<std::int32_t>{11, 12, 13, 15, 16, 17, 18, 19, 20, 21, 22, 23}));
  EXPECT_TRUE(same_ids(only_mesh(kept).vertex_ids, soup.vertex_ids, 8));
  EXPECT_GT(count_after(kept, Numbering), 0U);

  RepairOptions options;
  options.fixes.insert(Numbering);
  const RepairResult renumbered = fix_defects(soup, options);
  EXPECT_EQ(count_after(renumbered, Numbering), 0U);
  EXPECT_TRUE(same_soup(only_mesh(renumbered), shapes::cube()));
}

TEST(RepairOptions, BordersThatAreMeantStayOpenAndInPlace) {
  RepairOptions options;
  options.borders = Borders::Intended;
  EXPECT_TRUE(same_soup(only_mesh(fix_defects(shapes::open_cube(), options)), shapes::open_cube()));

  // A turned face is mended all the same.
  const std::array<Index, 1> one{2};
  const Soup turned = shapes::flipped(shapes::open_cube(), one);
  EXPECT_TRUE(same_soup(only_mesh(fix_defects(turned, options)), shapes::open_cube()));
}

TEST(RepairOptions, ShortEdgeOfABorderThatIsMeantStays) {
  // A third vertex of the border right beside the first.
  const Soup soup = shapes::make({{0, 0, 0}, {1e-12, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                 {{1, 0, 3}, {2, 1, 3}, {4, 2, 3}, {0, 4, 3}});
  RepairOptions options;
  options.borders = Borders::Intended;
  const RepairResult meant = fix_defects(soup, options);
  EXPECT_TRUE(same_soup(only_mesh(meant), soup));
  EXPECT_TRUE(is_refused(meant, DegenerateFacet, ""));
  EXPECT_EQ(only_mesh(fix_defects(soup)).positions.size(), 4U);
}

TEST(RepairOptions, WhatMeetsABorderThatIsClosedIsCutAfterAll) {
  // Two cubes that touch; a face of the first has copies of its corners. Once they are welded,
  // there is no border any more at which cutting would have to stop.
  Soup soup = shapes::merged(shapes::cube(), shapes::cube(0.5, {1, 0, 0}));
  for (Index& corner : soup.triangles.front()) {
    soup.positions.push_back(soup.positions[corner]);
    corner = static_cast<Index>(soup.n_vertices() - 1);
  }
  RepairOptions options;
  options.borders = Borders::Intended;
  EXPECT_TRUE(is_good(only_mesh(fix_defects(soup, options))));
}

TEST(RepairOptions, WhatWouldMoveIsRefusedWhereNothingMay) {
  RepairOptions options;
  options.max_deviation = {0.0, Deviation::Unit::Length};
  const Soup soup = with_needles();
  const RepairResult result = fix_defects(soup, options);
  EXPECT_TRUE(same_soup(only_mesh(result), soup));
  EXPECT_EQ(count_after(result, DegenerateFacet), 2U);
  EXPECT_TRUE(is_refused(result, DegenerateFacet, "deviation"));
  EXPECT_EQ(result.deviation, 0.0);
  // A repair that moves nothing is done.
  EXPECT_EQ(only_mesh(fix_defects(unwelded(shapes::cube()), options)).n_vertices(), 8U);
}

/// A closed, slender pyramid with its tip here, from above or below.
Soup spike(const Vec3& tip, double height) {
  const Vec3 foot = tip + Vec3(0, 0, height);
  const Soup up = shapes::make(
      {tip, foot + Vec3(-0.5, -0.5, 0), foot + Vec3(0.5, -0.5, 0), foot + Vec3(0, 0.5, 0)},
      {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}});
  return height > 0 ? up : shapes::flipped(up);
}

/// A closed roof, its eaves a square from -10 to 10, and on its top a short edge from a dip at
/// (-0.2, 0, 0) to a bump at (0.2, 0, 0.3): 0.5 long.
Soup short_edge_from_dip_to_bump() {
  return shapes::make({{-10, -10, 0},
                       {10, -10, 0},
                       {10, 10, 0},
                       {-10, 10, 0},
                       {-0.2, 0, 0},
                       {0.2, 0, 0.3},
                       {0, -10, 0},
                       {0, 10, 0},
                       {0, 0, -20}},
                      {{0, 6, 4},
                       {6, 5, 4},
                       {6, 1, 5},
                       {1, 2, 5},
                       {2, 7, 5},
                       {7, 4, 5},
                       {7, 3, 4},
                       {3, 0, 4},
                       {6, 0, 8},
                       {1, 6, 8},
                       {2, 1, 8},
                       {7, 2, 8},
                       {3, 7, 8},
                       {0, 3, 8}});
}

TEST(RepairOptions, OperationThatWouldMakeFacesIntersectIsUndone) {
  RepairOptions options;
  // The edge cannot be made as long as this within the deviation.
  options.tolerances.degeneracy = 0.75;
  options.max_deviation = {0.2, Deviation::Unit::Length};
  options.fixes.erase(Disjoint);
  const Soup roof = short_edge_from_dip_to_bump();
  const RepairResult alone = fix_defects(roof, options);
  EXPECT_EQ(alone.before.count(DegenerateFacet), 2U);
  EXPECT_EQ(count_after(alone, DegenerateFacet), 0U);

  // One tip in the dip, 0.1 above it, another one in the bump, 0.1 below it: wherever on the edge
  // the two ends are brought together, the surface passes one of them.
  Soup soup = shapes::merged(roof, spike({-0.2, 0, 0.1}, 10));
  soup = shapes::merged(std::move(soup), spike({0.2, 0, 0.2}, -5));
  const RepairResult result = fix_defects(soup, options);
  EXPECT_EQ(result.before.count(SelfIntersection), 0U);
  EXPECT_EQ(count_after(result, SelfIntersection), 0U);
  EXPECT_EQ(count_after(result, DegenerateFacet), 2U);
  EXPECT_TRUE(is_refused(result, DegenerateFacet, "intersect"));
  EXPECT_TRUE(same_bits(only_mesh(result).positions, soup.positions));
}

TEST(RepairOptions, OnlyTheHoleNearestToAPointIsFilled) {
  // Without a face at the vertex (0, 0, 1) of an octahedron, and one at (0, 0, -1).
  Soup soup = shapes::make({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                           {{1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {0, 3, 5}});
  RepairOptions options;
  options.fill.at = Vec3(0.3, 0.3, 0.4);
  const RepairResult result = fix_defects(soup, options);
  EXPECT_EQ(result.before.count(Hole), 2U);
  EXPECT_EQ(count_after(result, Hole), 1U);
  ASSERT_EQ(only_mesh(result).n_faces(), 7U);
  EXPECT_EQ(only_mesh(result).triangles.back()[0] + only_mesh(result).triangles.back()[1] +
                only_mesh(result).triangles.back()[2],
            0U + 1U + 4U);
}

TEST(RepairOptions, HolesWithMoreEdgesThanAskedForStay) {
  RepairOptions options;
  options.fill.max_edges = 3;
  EXPECT_TRUE(same_soup(only_mesh(fix_defects(shapes::open_cube(), options)), shapes::open_cube()));
  options.fill.max_edges = 4;
  EXPECT_EQ(count_after(fix_defects(shapes::open_cube(), options), Hole), 0U);
}

TEST(RepairOptions, SmoothPatchHasVerticesOfItsOwnAndALinearOneHasNone) {
  // The cap of a sphere is gone: a hole of sixteen edges.
  Soup soup = shapes::uv_sphere(12, 16);
  const std::size_t n_whole = soup.n_vertices();
  std::vector<Index> cap;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const Triangle& t = soup.triangles[f];
    if (std::all_of(t.begin(), t.end(), [&](Index v) { return soup.positions[v].z() > 0.6; })) {
      cap.push_back(f);
    }
  }
  soup = shapes::without_faces(std::move(soup), cap);
  RepairOptions options;
  options.fill.shape = FillShape::Linear;
  const RepairResult linear = fix_defects(soup, options);
  EXPECT_EQ(count_after(linear, Hole), 0U);
  EXPECT_LT(only_mesh(linear).n_vertices(), n_whole);
  options.fill.shape = FillShape::Smooth;
  const RepairResult smooth = fix_defects(soup, options);
  EXPECT_EQ(count_after(smooth, Hole), 0U);
  EXPECT_GT(only_mesh(smooth).n_vertices(), only_mesh(linear).n_vertices());
  // It bulges, where a linear one is flat.
  EXPECT_GT(volume_of(only_mesh(smooth)), volume_of(only_mesh(linear)));
  // The sphere bends towards the hole.
  EXPECT_EQ(only_mesh(fix_defects(soup)).n_vertices(), only_mesh(smooth).n_vertices());
}

TEST(RepairOptions, EndsOfATubeGetFlatLids) {
  // The wall goes on straight across its rims, which are creases.
  const Soup wall = shapes::uv_sphere(40, 24);
  Soup tube = wall;
  for (Vec3& p : tube.positions) {
    const double radius = p.head<2>().norm();
    if (radius > 0.0) p.head<2>() /= radius;
  }
  std::vector<Index> ends;
  for (Index f = 0; f < tube.n_faces(); ++f) {
    const Triangle& t = tube.triangles[f];
    if (std::any_of(t.begin(), t.end(),
                    [&](Index v) { return std::abs(tube.positions[v].z()) > 0.9; })) {
      ends.push_back(f);
    }
  }
  tube = shapes::without_faces(std::move(tube), ends);
  const RepairResult result = fix_defects(tube);
  EXPECT_EQ(count_after(result, Hole), 0U);
  for (const Vec3& p : only_mesh(result).positions) EXPECT_LE(std::abs(p.z()), 0.9);
}

TEST(RepairOptions, SheetStaysOpenUnlessItsHolesAreAskedForByName) {
  // A square hole in the middle of a flat sheet.
  Soup soup = shapes::grid(5, 5);
  const std::array<Index, 2> middle{24, 25};
  soup = shapes::without_faces(std::move(soup), middle);
  const RepairResult open = fix_defects(soup);
  EXPECT_TRUE(same_soup(only_mesh(open), soup));
  EXPECT_TRUE(is_refused(open, Hole, "sheet"));
  RepairOptions options;
  options.fill.sheets = FillSheets::Yes;
  options.fill.max_edges = 4;
  const RepairResult filled = fix_defects(soup, options);
  EXPECT_EQ(count_after(filled, Hole), 1U);
  EXPECT_EQ(only_mesh(filled).n_faces(), 50U);
}

TEST(RepairOptions, BordersAreWeldedWithinALengthGivenByName) {
  const Soup soup = two_triangles_apart(0.001);
  EXPECT_EQ(only_mesh(fix_defects(soup)).n_vertices(), 6U);
  RepairOptions options;
  options.weld_within = 0.0011;
  EXPECT_EQ(only_mesh(fix_defects(soup, options)).n_vertices(), 4U);
  options.fixes = {};
  EXPECT_EQ(only_mesh(fix_defects(soup, options)).n_vertices(), 4U);
  options.weld_within = 0.0009;
  EXPECT_EQ(only_mesh(fix_defects(soup, options)).n_vertices(), 6U);
}

TEST(RepairOptions, EverythingIsTurnedOnceWhereAskedFor) {
  RepairOptions options;
  options.turn = Turn::Everything;
  options.fixes = {};
  const Soup turned = only_mesh(fix_defects(cube_with_normals(), options));
  EXPECT_NEAR(volume_of(turned), -1.0, 1e-15);
  EXPECT_EQ(turned.normals[7], -cube_with_normals().normals[7]);
  // A component that is turned inwards is turned back where that is to be fixed.
  options.fixes = {Inward};
  EXPECT_NEAR(volume_of(only_mesh(fix_defects(shapes::cube(), options))), 1.0, 1e-15);
}

/// A tetrahedron, a cube and an octahedron: 4, 12 and 8 faces.
Soup three_solids() {
  Soup soup = shapes::merged(shapes::tetrahedron(), shapes::cube(1.0, {5, 0, 0}));
  return shapes::merged(std::move(soup), shapes::translated(shapes::uv_sphere(2, 4), {0, 5, 0}));
}

TEST(RepairOptions, OnlyTheLargestComponentsAreKept) {
  RepairOptions options;
  options.keep_largest = 2;
  const RepairResult result = fix_defects(three_solids(), options);
  EXPECT_EQ(only_mesh(result).n_faces(), 20U);
  EXPECT_EQ(only_mesh(result).n_vertices(), 14U);
  ASSERT_EQ(result.log.operations.size(), 1U);
  EXPECT_EQ(result.log.operations.front().removed_faces, (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(result.log.operations.front().removed_vertices, (std::vector<Index>{0, 1, 2, 3}));
}

TEST(RepairOptions, ComponentsBecomeMeshesWhereAskedFor) {
  RepairOptions options;
  options.fixes.insert(Disjoint);
  const RepairResult result = fix_defects(three_solids(), options);
  ASSERT_EQ(result.meshes.size(), 3U);
  const std::array<std::size_t, 3> n_faces{12, 8, 4};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(result.meshes[i].tracked.soup.n_faces(), n_faces[i]);
    EXPECT_EQ(result.meshes[i].remaining.count(Disjoint), 0U);
  }
}

TEST(RepairOptions, ComponentsThatAreNotKeptAreInTheLogWhenTheOthersBecomeMeshes) {
  RepairOptions options;
  options.fixes.insert(Disjoint);
  options.keep_largest = 1;
  const RepairResult result = fix_defects(three_solids(), options);
  EXPECT_EQ(only_mesh(result).n_faces(), 12U);
  std::set<Index> removed;
  for (const LoggedOperation& operation : result.log.operations) {
    removed.insert(operation.removed_faces.begin(), operation.removed_faces.end());
  }
  EXPECT_EQ(removed.size(), 12U);
}

TEST(RepairOptions, ContactsAreParted) {
  const Soup soup = shapes::two_tetrahedra_sharing_vertex();
  const RepairResult result = fix_defects(soup);
  EXPECT_EQ(count_after(result, NonManifold), 0U);
  EXPECT_EQ(count_after(result, SelfIntersection), 0U);
  EXPECT_GT(result.deviation, 0.0);
  EXPECT_LT(result.deviation, 1e-12);
}

TEST(RepairOptions, ContactsAreKeptWhereAskedFor) {
  const Soup soup = shapes::two_tetrahedra_sharing_vertex();
  RepairOptions options;
  options.contact = Contact::Keep;
  const RepairResult result = fix_defects(soup, options);
  const Soup& kept = only_mesh(result);
  EXPECT_EQ(count_after(result, NonManifold), 0U);
  EXPECT_EQ(result.deviation, 0.0);
  ASSERT_EQ(kept.n_vertices(), 8U);
  for (std::size_t f = 0; f < 8; ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(kept.positions[kept.triangles[f][k]], soup.positions[soup.triangles[f][k]]);
    }
  }
}

TEST(RepairOptions, DefectsAreCutButCounted) {
  Soup soup = shapes::cube();
  for (int i = 0; i < 5; ++i) soup.positions.emplace_back(9, 9, i);
  RepairOptions options;
  options.fixes = {};
  options.max_defects = 3;
  const RepairResult result = fix_defects(soup, options);
  EXPECT_EQ(result.before.defects.size(), 3U);
  EXPECT_EQ(result.before.count(OrphanVertex), 5U);
  EXPECT_EQ(result.meshes.front().remaining.defects.size(), 3U);
  EXPECT_EQ(count_after(result, OrphanVertex), 5U);
}

TEST(RepairOptions, ListenerIsToldEveryPass) {
  std::vector<std::string> phases;
  RepairOptions options;
  options.fixes = {Flipped, OrphanVertex};
  options.on_progress = [&](const RepairProgress& progress) { phases.emplace_back(progress.pass); };
  static_cast<void>(fix_defects(shapes::cube(), options));
  EXPECT_EQ(phases, (std::vector<std::string>{"orient consistently", "drop orphans"}));
}

TEST(RepairOptions, RepairThatIsStoppedKeepsWhatItHasAndSaysSo) {
  Soup soup = shapes::open_cube();
  soup.positions.emplace_back(5, 5, 5);
  RepairOptions options;
  std::size_t n_asked = 0;
  options.wants_to_stop = [&] { return ++n_asked > 1000; };
  const RepairResult whole = fix_defects(soup, options);
  EXPECT_FALSE(whole.is_stopped);
  EXPECT_EQ(count_after(whole, Hole), 0U);
  const std::size_t n_in_all = n_asked;
  for (std::size_t n_allowed = 0; n_allowed < n_in_all; ++n_allowed) {
    n_asked = 0;
    options.wants_to_stop = [&] { return ++n_asked > n_allowed; };
    const RepairResult stopped = fix_defects(soup, options);
    EXPECT_TRUE(stopped.is_stopped);
    EXPECT_LE(count_after(stopped, Hole), 1U);
    EXPECT_LE(count_after(stopped, OrphanVertex), 1U);
  }
  // Before anything was tried nothing is changed.
  options.wants_to_stop = [] { return true; };
  EXPECT_EQ(only_mesh(fix_defects(soup, options)).triangles, soup.triangles);
}

TEST(RepairOptions, StepsOfTheLogAddUpTheirOperations) {
  Soup soup = with_needles();
  soup.triangles.push_back(soup.triangles[9]);
  soup.triangles.push_back({4, 4, 5});
  const RepairResult result = fix_defects(soup);
  std::vector<LogStep> sums(result.log.steps.size());
  for (const LoggedOperation& operation : result.log.operations) {
    LogStep& sum = sums.at(operation.step);
    ++sum.operations;
    sum.faces_removed += operation.removed_faces.size();
    sum.faces_changed += operation.changed_faces.size();
    sum.vertices_removed += operation.removed_vertices.size();
    sum.distance = std::max(sum.distance, operation.distance);
  }
  ASSERT_GE(sums.size(), 2U);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    EXPECT_EQ(sums[i].operations, result.log.steps[i].operations);
    EXPECT_EQ(sums[i].faces_removed, result.log.steps[i].faces_removed);
    EXPECT_EQ(sums[i].faces_changed, result.log.steps[i].faces_changed);
    EXPECT_EQ(sums[i].vertices_removed, result.log.steps[i].vertices_removed);
    EXPECT_EQ(sums[i].distance, result.log.steps[i].distance);
  }
}

}  // namespace
}  // namespace meshalyzer
