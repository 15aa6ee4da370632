#include "meshalyzer/set/set_totals.h"

#include "meshalyzer/analysis/analyze.h"
#include "support/described_set.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

using Reasons = std::vector<std::string>;
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

Analysis analyzed(const Soup& soup) {
  AnalysisOptions options;
  options.keep_values = true;
  return analyze(soup, "soup", options);
}

SetOptions intersecting() {
  SetOptions options;
  options.request.between.intersections = true;
  return options;
}

SetOptions separating() {
  SetOptions options;
  options.request.between.separation.emplace();
  return options;
}

/// The totals of meshes called a, b, ...
SetTotals totals_of(const std::vector<Soup>& soups, const SetOptions& options = {}) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < soups.size(); ++i) {
    names.push_back(std::string(1, static_cast<char>('a' + i)));
  }
  SetTotals totals(names, options);
  for (Index i = 0; i < soups.size(); ++i) {
    totals.add_mesh(i, analyzed(soups[i]));
  }
  return totals;
}

ObjectFindings separations(Index owner, const std::vector<double>& distances) {
  ObjectSeparation separation;
  separation.distances = distances;
  separation.vertices.resize(distances.size());
  return {.owner = owner, .intersections = std::nullopt, .separation = separation};
}

TEST(SetTotals, NoMeshesAddUpToNothing) {
  const SetAnalysis set = SetTotals({}, {}).finish();
  EXPECT_EQ(set.meshes, 0U);
  EXPECT_EQ(set.faces, 0U);
  EXPECT_EQ(set.area, 0.0);
  EXPECT_FALSE(set.volume.value.has_value());
  EXPECT_EQ(set.volume.reason, "");
  EXPECT_FALSE(set.good.has_value());
  EXPECT_TRUE(set.not_good.empty());
  EXPECT_FALSE(set.intersections.has_value());
  EXPECT_FALSE(set.separation.has_value());
  EXPECT_EQ(set.separation_reason, "");
  EXPECT_EQ(set.statistics.value().face_area.count, 0U);
}

TEST(SetTotals, CountsAndMeasuresAddUp) {
  // Two cubes and a cavity: V 8 + 8 + 16, E 18 + 18 + 36, F 12 + 12 + 24, areas 6 + 24 + 60,
  // volumes 1 - 8 + 26.
  const SetAnalysis set = totals_of({shapes::cube(), shapes::flipped(shapes::cube(2.0)),
                                     shapes::nested_cubes(shapes::InnerShell::Cavity)})
                              .finish();
  EXPECT_EQ(set.names, (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(set.meshes, 3U);
  EXPECT_EQ(set.unreadable, 0U);
  EXPECT_EQ(set.vertices, 32U);
  EXPECT_EQ(set.edges, 72U);
  EXPECT_EQ(set.faces, 48U);
  EXPECT_EQ(set.components, 4U);
  EXPECT_EQ(set.boundaries, 0U);
  EXPECT_EQ(set.intersecting_pairs_within, 0U);
  EXPECT_NEAR(set.area, 90.0, 1e-12);
  EXPECT_NEAR(set.volume.value.value(), 19.0, 1e-12);
  EXPECT_EQ(set.volume.reason, "");
}

TEST(SetTotals, MeshesWithoutVolumeAreSaid) {
  const SetAnalysis set = totals_of({shapes::cube(), shapes::grid(2, 2), Soup()}).finish();
  EXPECT_NEAR(set.volume.value.value(), 1.0, 1e-14);
  EXPECT_EQ(set.volume.reason, "meshes without a volume: 2");
  EXPECT_EQ(set.boundaries, 1U);
}

TEST(SetTotals, NoMeshWithVolumeLeavesNone) {
  const SetAnalysis set = totals_of({shapes::grid(2, 2)}).finish();
  EXPECT_FALSE(set.volume.value.has_value());
  EXPECT_EQ(set.volume.reason, "meshes without a volume: 1");
}

TEST(SetTotals, PairsWithinMeshesAddUp) {
  // Three pairs each: see the corner of the second tetrahedron in the first.
  const Soup soup = shapes::merged(shapes::tetrahedron(),
                                   shapes::translated(shapes::tetrahedron(), Vec3::Constant(0.2)));
  EXPECT_EQ(totals_of({soup, soup}).finish().intersecting_pairs_within, 6U);
}

TEST(SetTotals, OneSearchThatWasStoppedMakesTheSumOfPairsALowerBound) {
  Analysis stopped;
  stopped.characteristics.is_search_stopped = true;
  SetTotals exact({"a.mesh"}, {});
  exact.add_mesh(0, Analysis());
  EXPECT_FALSE(exact.finish().is_search_within_stopped);
  SetTotals bounded({"a.mesh", "b.mesh", "c.mesh"}, {});
  bounded.add_mesh(0, Analysis());
  bounded.add_mesh(1, stopped);
  bounded.add_mesh(2, Analysis());
  EXPECT_TRUE(bounded.finish().is_search_within_stopped);
}

TEST(SetTotals, StatisticsAreThoseOfAllValuesTogether) {
  const std::vector<Soup> soups{shapes::icosphere(2), shapes::torus(2, 0.5, 20, 11),
                                shapes::scaled(shapes::open_cube(), 1e5), shapes::grid(3, 2)};
  const SetStatistics statistics = totals_of(soups).finish().statistics.value();
  MeasuredValues all;
  for (const Soup& soup : soups) {
    const MeasuredValues values = analyzed(soup).values;
    for (std::size_t i = 0; i < kElementMeasures<std::vector<double>>.size(); ++i) {
      all[i].insert(all[i].end(), values[i].begin(), values[i].end());
    }
  }
  const auto text = [](const Statistics& s) { return test::Describer().add("", s).text(); };
  for (std::size_t i = 0; i < kElementMeasures<Statistics>.size(); ++i) {
    EXPECT_EQ(text(statistics[i]), text(summarize(all[i]))) << i;
  }
  // 20 4^2 faces, 2 20 11, 10 and 12.
  EXPECT_EQ(statistics.face_area.count, 782U);
}

TEST(SetTotals, StatisticsAreLeftOutWhereNotAskedFor) {
  SetOptions options;
  options.request.between.statistics = false;
  EXPECT_FALSE(totals_of({shapes::cube()}, options).finish().statistics.has_value());
}

TEST(SetTotals, AttributesAloneAreNeitherMeasuredNorJudged) {
  SetOptions options;
  options.request.mesh.scope = Scope::AttributesOnly;
  SetTotals totals({"a"}, options);
  totals.add_mesh(0, analyze(shapes::cube(), "a",
                             {options.request.mesh, false, false, MeshKept::Nothing, {}, {}}));
  const SetAnalysis set = totals.finish();
  EXPECT_FALSE(set.is_measured);
  EXPECT_FALSE(set.statistics.has_value());
  EXPECT_FALSE(set.good.has_value());
  EXPECT_EQ(set.faces, 12U);
}

TEST(SetTotals, GoodMeshesAreCountedAndOthersNamedWithTheirReasons) {
  SetTotals totals = totals_of({shapes::cube(), shapes::flipped(shapes::cube()), shapes::cube()});
  totals.add_unreadable(3, "d:1: no mesh");
  const SetAnalysis set = totals.finish();
  EXPECT_EQ(set.meshes, 3U);
  EXPECT_EQ(set.unreadable, 1U);
  EXPECT_EQ(set.good, 2U);
  ASSERT_EQ(set.not_good.size(), 2U);
  EXPECT_EQ(set.not_good[0].mesh, 1U);
  EXPECT_EQ(set.not_good[0].reasons, Reasons{"not outward"});
  EXPECT_EQ(set.not_good[1].mesh, 3U);
  EXPECT_EQ(set.not_good[1].reasons, Reasons{"cannot be read: d:1: no mesh"});
}

TEST(SetTotals, NoGoodMeshIsACountToo) {
  EXPECT_EQ(totals_of({shapes::open_cube()}).finish().good, 0U);
}

TEST(SetTotals, ThresholdsDecideWhereThereAreAny) {
  SetOptions options;
  options.request.mesh.goodness = {.aspect_ratio = 9, .edge_angle_degrees = 0, .edge_length = 1};
  SetTotals totals({"a"}, options);
  totals.add_mesh(0, analyze(shapes::cube(), "a",
                             {options.request.mesh, false, false, MeshKept::Nothing, {}, {}}));
  const SetAnalysis set = totals.finish();
  EXPECT_EQ(set.good, 0U);
  EXPECT_EQ(set.not_good.at(0).reasons, Reasons{"shortest edge 1 is not longer than 1"});
}

TEST(SetTotals, IntersectionsAreInOrderOfMeshesThenFaces) {
  SetTotals totals = totals_of({shapes::cube(), shapes::cube(), shapes::cube()}, intersecting());
  const SetPair a{0, 7, 1, 2, ContactKind::Crossing};
  const SetPair b{0, 7, 1, 3, ContactKind::Touching};
  const SetPair c{0, 8, 1, 1, ContactKind::Duplicate};
  const SetPair d{0, 1, 2, 1, ContactKind::CoplanarOverlap};
  const SetPair e{1, 1, 2, 1, ContactKind::Crossing};
  totals.add_findings({2, SetIntersections{{e, d}, {{2, 1}, {0, 2}}, {}}, std::nullopt});
  totals.add_findings({1, SetIntersections{{c, a, b}, {{1, 0}}, {{2, 0}, {1, 2}}}, std::nullopt});
  const SetIntersections found = totals.finish().intersections.value();
  EXPECT_EQ(found.pairs, (std::vector<SetPair>{a, b, c, d, e}));
  EXPECT_EQ(found.contained, (std::vector<ContainedMesh>{{0, 2}, {1, 0}, {2, 1}}));
  EXPECT_EQ(found.partly_contained, (std::vector<ContainedMesh>{{1, 2}, {2, 0}}));
}

TEST(SetTotals, NothingFoundIsAnAnswerWhereAsked) {
  const SetAnalysis set = totals_of({shapes::cube()}, intersecting()).finish();
  EXPECT_TRUE(set.intersections.value().pairs.empty());
}

TEST(SetTotals, SeparationIsSummedUpByMeshAndForAll) {
  SetTotals totals = totals_of({shapes::cube(), shapes::cube(), shapes::cube()}, separating());
  EXPECT_EQ(totals.why_no_separation(), "");
  // -0 is the rounded distance of a vertex inside.
  totals.add_findings(separations(2, {3, kNothing, -1, -0.0}));
  totals.add_findings(separations(0, {1, 2}));
  const SetSeparation separation = totals.finish().separation.value();
  EXPECT_FALSE(separation.is_forced);
  EXPECT_EQ(separation.options, SeparationOptions());
  EXPECT_EQ(separation.without_closest, 1U);
  EXPECT_EQ(separation.inside, 2U);
  ASSERT_EQ(separation.meshes.size(), 2U);
  EXPECT_EQ(separation.meshes[0].mesh, 0U);
  EXPECT_EQ(separation.meshes[0].distance.mean, 1.5);
  EXPECT_EQ(separation.meshes[0].without_closest, 0U);
  EXPECT_EQ(separation.meshes[0].inside, 0U);
  EXPECT_EQ(separation.meshes[1].mesh, 2U);
  EXPECT_EQ(separation.meshes[1].distance.count, 3U);
  EXPECT_EQ(separation.meshes[1].distance.min, -1.0);
  EXPECT_EQ(separation.meshes[1].without_closest, 1U);
  EXPECT_EQ(separation.meshes[1].inside, 2U);
  EXPECT_EQ(separation.all.count, 5U);
  EXPECT_EQ(separation.all.total, 5.0);
}

TEST(SetTotals, SeparationNeedsEveryMeshToBeGood) {
  SetTotals totals = totals_of({shapes::cube(), shapes::open_cube()}, separating());
  const std::string reason =
      "every mesh must be good, and b is not (not closed); the measurement can be forced";
  EXPECT_EQ(totals.why_no_separation(), reason);
  const SetAnalysis set = totals.finish();
  EXPECT_FALSE(set.separation.has_value());
  EXPECT_EQ(set.separation_reason, reason);
}

TEST(SetTotals, FurtherMeshesThatForbidSeparationAreCounted) {
  SetTotals totals = totals_of({shapes::grid(1, 1), shapes::open_cube()}, separating());
  EXPECT_EQ(totals.why_no_separation(),
            "every mesh must be good, and a is not (not closed) and 1 more mesh is not; the "
            "measurement can be forced");
  totals.add_unreadable(2, "away");
  EXPECT_EQ(totals.why_no_separation(),
            "every mesh must be good, and a is not (not closed) and 2 more meshes are not; the "
            "measurement can be forced");
}

TEST(SetTotals, ForceMeasuresWhatIsNotGoodAndSaysSo) {
  SetOptions options = separating();
  options.request.between.force = true;
  SetTotals totals = totals_of({shapes::open_cube()}, options);
  EXPECT_EQ(totals.why_no_separation(), "");
  EXPECT_TRUE(totals.finish().separation.value().is_forced);
  EXPECT_FALSE(totals_of({shapes::cube()}, options).finish().separation.value().is_forced);
}

}  // namespace
}  // namespace meshalyzer
