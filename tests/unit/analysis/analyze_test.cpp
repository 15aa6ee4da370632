#include "meshalyzer/analysis/analyze.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/report/json/report.h"
#include "support/constants.h"
#include "support/shape_figures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

std::string json(const Soup& soup, AnalysisOptions options = {}) {
  const std::vector<Analysis> meshes{analyze(soup, "soup", options)};
  return json_report(meshes, nullptr, JsonOffenders::List);
}

void expect_same(const Attributes& a, const Attributes& b) {
  const auto same = [](const Answer& x, const Answer& y) {
    EXPECT_EQ(x.value, y.value);
    EXPECT_EQ(x.reason, y.reason);
  };
  same(a.closed, b.closed);
  same(a.manifold, b.manifold);
  same(a.orientable, b.orientable);
  same(a.consistent, b.consistent);
  same(a.outward, b.outward);
}

/// A torus of 115,200 faces, some of them turned over, with a sphere across it and one in its tube.
Soup large_and_bad() {
  std::vector<Index> turned;
  for (Index f = 0; f < 115200; f += 977) turned.push_back(f);
  Soup soup = shapes::flipped(shapes::torus(2, 0.7, 240, 240), turned);
  soup = shapes::merged(soup, shapes::translated(shapes::icosphere(3), {2, 0, 0}));
  soup = shapes::merged(soup,
                        shapes::translated(shapes::scaled(shapes::icosphere(2), 0.1), {-2, 0, 0}));
  return shapes::shuffled_faces(shapes::renumbered_vertices(soup, 5), 6);
}

TEST(Analyze, CountsOfShapesAreThoseOfTheirFormulas) {
  for (const ShapeFigures& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    const Characteristics c = analyze(shape.soup, shape.name).characteristics;
    EXPECT_EQ(c.vertices, shape.soup.n_vertices());
    EXPECT_EQ(c.faces, shape.soup.n_faces());
    EXPECT_EQ(c.edges, shape.edges);
    EXPECT_EQ(c.components, shape.components);
    EXPECT_EQ(c.edge_components, shape.edge_components);
    EXPECT_EQ(c.boundaries, shape.boundaries);
    EXPECT_EQ(c.border_edges, shape.border_edges);
    EXPECT_EQ(c.non_manifold_edges, shape.non_manifold_edges);
    EXPECT_EQ(c.non_manifold_vertices, shape.non_manifold_vertices);
    EXPECT_EQ(c.pinched_vertices, shape.pinched_vertices);
    EXPECT_EQ(c.genus.value, shape.genus);
    EXPECT_EQ(c.genus_of_components, shape.genus);
  }
}

TEST(Analyze, AttributesOfShapesAreTheirs) {
  for (const ShapeFigures& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    const Attributes a = analyze(shape.soup, shape.name).attributes;
    EXPECT_EQ(a.closed.value, shape.is_closed());
    EXPECT_EQ(a.manifold.value, shape.manifold);
    EXPECT_EQ(a.orientable.value, shape.orientable);
    EXPECT_EQ(a.consistent.value, shape.consistent);
    EXPECT_EQ(a.outward.value, shape.outward);
    for (const Answer& answer : {a.closed, a.manifold, a.orientable, a.consistent, a.outward}) {
      EXPECT_EQ(answer.reason.empty(), answer.value.has_value());
    }
  }
}

TEST(Analyze, AreasAndVolumesOfShapesAreThoseOfTheirFormulas) {
  for (const ShapeFigures& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    const Characteristics c = analyze(shape.soup, shape.name).characteristics;
    if (shape.area) {
      EXPECT_NEAR(c.area, *shape.area, 1e-12 * *shape.area);
    }
    EXPECT_EQ(c.volume.value.has_value(), shape.volume.has_value());
    if (shape.volume) {
      EXPECT_NEAR(c.volume.value.value_or(0), *shape.volume, 1e-12 * *shape.volume);
    }
    EXPECT_EQ(c.volume.reason.empty(), shape.volume.has_value());
  }
}

TEST(Analyze, SolidsOfOneShellDoNotIntersectThemselves) {
  for (const ShapeFigures& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    if (shape.volume.value_or(0) > 0) {
      EXPECT_EQ(analyze(shape.soup, shape.name).characteristics.intersecting_pairs, 0U);
    }
  }
}

TEST(Analyze, CubeHasTheStatisticsOfHalfSquares) {
  const Characteristics c = analyze(shapes::cube(2.0), "cube").characteristics;
  EXPECT_EQ(c.face_area.count, 12U);
  EXPECT_EQ(c.face_area.median, 2.0);
  EXPECT_NEAR(c.aspect_ratio.max, 2.0, 1e-14);
  EXPECT_NEAR(c.corner_angle.min, 45.0, 1e-13);
  EXPECT_EQ(c.edge_length.count, 18U);
  EXPECT_EQ(c.edge_length.median, 2.0);
  EXPECT_EQ(c.edge_angle.count, 18U);
  EXPECT_NEAR(c.edge_angle.mean, (12 * 270.0 + 6 * 180.0) / 18, 1e-12);
  // Each edge has two ends.
  EXPECT_EQ(c.vertex_valence.count, 8U);
  EXPECT_EQ(c.vertex_valence.total, 36.0);
  EXPECT_EQ(c.bounding_box.max(), Vec3(2, 2, 2));
}

TEST(Analyze, OrphansCountAsVerticesOnly) {
  Soup soup = shapes::cube();
  soup.positions.emplace_back(50, 50, 50);
  const Characteristics c = analyze(soup, "cube").characteristics;
  EXPECT_EQ(c.vertices, 9U);
  EXPECT_EQ(c.vertex_valence.count, 8U);
  EXPECT_EQ(c.bounding_box.max(), Vec3(1, 1, 1));
  EXPECT_NEAR(c.volume.value.value(), 1.0, 1e-14);
}

TEST(Analyze, BrokenFacesAreLeftOutOfTheComplex) {
  Soup soup = shapes::cube();
  soup.triangles.insert(soup.triangles.begin(), {{0, 0, 1}, {1, 2, kNoIndex}});
  soup.missing.push_back({1, 2, 40});
  const Analysis analysis = analyze(soup, "cube");
  EXPECT_EQ(analysis.characteristics.faces, 14U);
  EXPECT_EQ(analysis.characteristics.edges, 18U);
  EXPECT_EQ(analysis.characteristics.face_area.count, 12U);
  EXPECT_EQ(analysis.attributes.outward.value, true);
  EXPECT_EQ(analysis.components.at(0).first_face, 2U);
}

TEST(Analyze, UnweldedSeamsAreCountedApart) {
  // Two halves of a square that have their common edge twice.
  const Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                 {{0, 1, 2}, {3, 4, 5}});
  const Characteristics c = analyze(soup, "square").characteristics;
  EXPECT_EQ(c.components, 2U);
  EXPECT_EQ(c.intersecting_pairs, 1U);
  EXPECT_EQ(c.unwelded_pairs, 1U);
  EXPECT_EQ(c.intersecting_faces, 2U);
  EXPECT_EQ(c.indistinguishable_vertices, 4U);
}

TEST(Analyze, AttributesAloneAreTheSame) {
  AnalysisOptions alone;
  alone.scope = Scope::AttributesOnly;
  std::vector<Soup> soups{Soup{},
                          shapes::merged(shapes::cube(), shapes::cube(1.0, {0.5, 0.25, 0.125}))};
  for (const ShapeFigures& shape : all_shapes()) soups.push_back(shape.soup);
  for (std::size_t i = 0; i < soups.size(); ++i) {
    SCOPED_TRACE(i);
    const Analysis everything = analyze(soups[i], "soup");
    const Analysis attributes = analyze(soups[i], "soup", alone);
    EXPECT_TRUE(everything.has_characteristics);
    EXPECT_FALSE(attributes.has_characteristics);
    expect_same(attributes.attributes, everything.attributes);
    EXPECT_EQ(attributes.characteristics.genus.value, everything.characteristics.genus.value);
  }
}

TEST(Analyze, FileIsKeptOnlyWhereAskedFor) {
  EXPECT_EQ(analyze(shapes::cube(), "cube").soup, nullptr);
  AnalysisOptions options;
  options.keep_soup = true;
  const Analysis analysis = analyze(shapes::cube(), "cube", options);
  ASSERT_NE(analysis.soup, nullptr);
  EXPECT_EQ(analysis.soup->positions, shapes::cube().positions);
  EXPECT_EQ(analysis.soup->triangles, shapes::cube().triangles);
}

TEST(Analyze, KeptMeshKnowsTheRecordsAndThePairsThatWereFound) {
  const Soup soup =
      shapes::merged(shapes::cube(), shapes::cube(1.0, {0.5, 0.25, 0.125}));  // they cross
  EXPECT_EQ(analyze(soup, "cubes").mesh, nullptr);
  AnalysisOptions options;
  options.keep_mesh = MeshKept::Everything;
  const Analysis analysis = analyze(soup, "cubes", options);
  ASSERT_NE(analysis.mesh, nullptr);
  EXPECT_EQ(analysis.mesh->soup().triangles, soup.triangles);
  EXPECT_FALSE(analysis.offenders.intersecting_pairs.empty());
  EXPECT_EQ(analysis.mesh->intersecting_pairs(), analysis.offenders.intersecting_pairs);
  EXPECT_EQ(analysis.vertex_ids.first, soup.vertex_ids.first);
}

TEST(Analyze, MeshForNeighboursIsKeptWithoutRecordsAndChangesNothing) {
  const Soup soup =
      shapes::merged(shapes::cube(), shapes::cube(1.0, {0.5, 0.25, 0.125}));  // they cross
  const Analysis plain = analyze(soup, "cubes");
  AnalysisOptions options;
  options.keep_mesh = MeshKept::ForNeighbours;
  const Analysis analysis = analyze(soup, "cubes", options);
  ASSERT_NE(analysis.mesh, nullptr);
  EXPECT_THROW((void)analysis.mesh->soup(), InvalidArgument);
  EXPECT_EQ(analysis.mesh->components().count, 2U);
  EXPECT_EQ(analysis.mesh->component_boxes().size(), 2U);
  EXPECT_EQ(analysis.mesh->tree().n_faces(), soup.n_faces());
  EXPECT_FALSE(plain.offenders.intersecting_pairs.empty());
  EXPECT_EQ(analysis.offenders.intersecting_pairs, plain.offenders.intersecting_pairs);
  EXPECT_EQ(analysis.components.size(), plain.components.size());
  EXPECT_EQ(analysis.components[1].outward, plain.components[1].outward);
}

TEST(Analyze, CurvatureIsMeasuredOnlyWhereAskedFor) {
  EXPECT_FALSE(analyze(shapes::cube(), "cube").curvature);
  AnalysisOptions options;
  options.curvature = VertexArea::Barycentric;
  const Analysis analysis = analyze(shapes::cube(), "cube", options);
  ASSERT_TRUE(analysis.curvature);
  EXPECT_EQ(analysis.curvature->area, VertexArea::Barycentric);
  // Three right angles lack at each of the eight corners (pi / 2 each), 4 pi in all.
  EXPECT_EQ(analysis.curvature->vertices[static_cast<std::size_t>(CurvatureState::Defined)], 8U);
  EXPECT_NEAR(analysis.curvature->total_angle_defect, 4 * M_PI, 1e-14);
  EXPECT_EQ(analysis.curvature->gaussian.count, 8U);
}

TEST(Analyze, BordersHaveNoCurvature) {
  AnalysisOptions options;
  options.curvature = VertexArea::Mixed;
  const Analysis analysis = analyze(shapes::open_cube(), "cube", options);
  ASSERT_TRUE(analysis.curvature);
  const auto n = [&](CurvatureState state) {
    return analysis.curvature->vertices[static_cast<std::size_t>(state)];
  };
  EXPECT_EQ(n(CurvatureState::Border), analysis.characteristics.border_edges);
  EXPECT_EQ(n(CurvatureState::Defined) + n(CurvatureState::Border),
            analysis.characteristics.vertices);
  EXPECT_EQ(analysis.curvature->mean.count, n(CurvatureState::Defined));
}

TEST(Analyze, FaceOfAVertexThatTheSoupDoesNotHaveIsRefused) {
  Soup soup = shapes::cube();
  soup.triangles[3][1] = 1'000'000'000;
  for (const Scope scope : {Scope::Everything, Scope::AttributesOnly}) {
    AnalysisOptions options;
    options.scope = scope;
    EXPECT_THROW(static_cast<void>(analyze(soup, "soup", options)), InvalidArgument);
  }
}

TEST(Analyze, ListenerHearsThePhasesInOrder) {
  std::vector<std::string> heard;
  AnalysisOptions options;
  options.on_phase = [&](std::string_view phase) { heard.emplace_back(phase); };
  EXPECT_EQ(analyze(shapes::cube(), "cube", options).path, "cube");
  EXPECT_EQ(heard, (std::vector<std::string>{"half-edges", "integrity", "topology", "measures",
                                             "face tree", "self-intersection", "solids"}));
}

TEST(Analyze, ReportIsTheSameForAnyNumberOfThreads) {
  const Soup soup = large_and_bad();
  const auto report_with = [&](std::size_t n_threads) {
    const ThreadLimit limit(n_threads);
    return json(soup);
  };
  const std::string one = report_with(1);
  EXPECT_TRUE(one == report_with(2)) << "two threads give another report than one";
}

TEST(Analyze, SizesBeyondADoubleAreInfiniteOrUndefinedNeverNaN) {
  const Analysis analysis = analyze(shapes::cube(1e300), "huge");
  EXPECT_TRUE(std::isinf(analysis.characteristics.area));
  EXPECT_FALSE(analysis.characteristics.volume.value.has_value());
  EXPECT_EQ(analysis.characteristics.volume.reason, "it is too large for a double");
  EXPECT_EQ(analysis.attributes.outward.value, true);
}

TEST(Analyze, RecordThatRepeatsAnIdAtTheSamePlaceIsNoSecondVertexThere) {
  Soup soup = shapes::tetrahedron();
  soup.vertex_ids.named = {1, 2, 3, 4, 4, 5};
  soup.positions.push_back(soup.positions[3]);
  soup.positions.push_back(soup.positions[0]);
  const Analysis analysis = analyze(soup, "soup");
  // Vertex 5 (record 5) is where vertex 1 (record 0) is; the second record of vertex 4 is nobody.
  EXPECT_EQ(analysis.offenders.indistinguishable_vertices, (std::vector<Index>{0, 5}));
}

TEST(Analyze, ThresholdsThatAreNotNumbersAreRefused) {
  const auto expect_refused = [](const AnalysisOptions& options) {
    EXPECT_THROW(static_cast<void>(analyze(shapes::cube(), "cube", options)), InvalidArgument);
  };
  AnalysisOptions options;
  for (const GoodnessThresholds& thresholds :
       {GoodnessThresholds{kNaN, 0, 0}, GoodnessThresholds{3, kNaN, 0},
        GoodnessThresholds{3, 0, kNaN}}) {
    options.goodness = thresholds;
    expect_refused(options);
  }
  for (std::optional<double> MeshRequest::*const threshold :
       {&MeshRequest::shorter_than, &MeshRequest::longer_than, &MeshRequest::angle_below_degrees,
        &MeshRequest::angle_above_degrees, &MeshRequest::aspect_above}) {
    AnalysisOptions one;
    one.*threshold = kNaN;
    expect_refused(one);
  }
}

TEST(Analyze, ThresholdsMayBeInfinite) {
  AnalysisOptions options;
  options.goodness = {kInfinity, 0, 0};
  options.shorter_than = kInfinity;
  const Analysis cube = analyze(shapes::cube(), "cube", options);
  EXPECT_TRUE(cube.goodness->good);
  // 12 edges of the cube and one diagonal a side.
  EXPECT_EQ(cube.offenders.short_edges->size(), 18U);
}

TEST(Analyze, PositionThatIsNotFiniteIsRefused) {
  Soup soup = shapes::cube();
  soup.positions[1].z() = kNaN;
  AnalysisOptions options;
  for (const Scope scope : {Scope::Everything, Scope::AttributesOnly}) {
    options.scope = scope;
    EXPECT_THROW(static_cast<void>(analyze(soup, "cube", options)), InvalidArgument);
  }
}

}  // namespace
}  // namespace meshalyzer
