#include "meshalyzer/picture/field.h"

#include "meshalyzer/base/error.h"
#include "support/constants.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

namespace meshalyzer {
namespace {

std::vector<double> values_of(const Soup& soup, FieldName name, VertexArea area = {}) {
  const PreparedMesh mesh(soup);
  const std::vector<Field> fields = compute_fields({.mesh = mesh, .area = area}, {name});
  return fields.at(0).values;
}

/// To the last bit, so that NaN is NaN.
std::vector<std::uint64_t> bits_of(const std::vector<double>& values) {
  std::vector<std::uint64_t> bits;
  for (const double value : values) {
    bits.push_back(std::isnan(value) ? 1U : std::bit_cast<std::uint64_t>(value));
  }
  return bits;
}

/// The faces round each vertex, whatever they are.
std::vector<std::vector<std::size_t>> faces_round_vertices(const Soup& soup) {
  std::vector<std::vector<std::size_t>> faces(soup.n_vertices());
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    for (const Index v : std::set<Index>(soup.triangles[f].begin(), soup.triangles[f].end())) {
      if (v != kNoIndex) {
        faces[v].push_back(f);
      }
    }
  }
  return faces;
}

/// A cube after a degenerate face, with a face in its middle that has no third corner, and a vertex
/// at its end that no face uses.
Soup cube_among_bad_records() {
  Soup soup = shapes::cube();
  soup.triangles.insert(soup.triangles.begin() + 6, Triangle{0, 1, kNoIndex});
  soup.triangles.insert(soup.triangles.begin(), Triangle{0, 7, 7});
  soup.missing = {{7, 2, 99}};
  soup.positions.emplace_back(5, 5, 5);
  return soup;
}

bool is_bad_record(std::size_t face) {
  return face == 0 || face == 7;
}

TEST(FieldOf, UndoesFieldName) {
  std::set<std::string_view> labels;
  for (const FieldName name : computed_field_names()) {
    EXPECT_EQ(field_of(field_name(name)), name);
    labels.insert(field_label(name));
  }
  EXPECT_EQ(labels.size(), computed_field_names().size());
  EXPECT_EQ(field_of("aspect-ratio"), FieldName::AspectRatio);
  EXPECT_EQ(field_of("Mean"), std::nullopt);
  // It compares two meshes, so that it cannot be asked for of one.
  EXPECT_EQ(field_of("deviation"), std::nullopt);
  EXPECT_EQ(field_of(""), std::nullopt);
}

TEST(ComputeFields, AreAsAskedForButThoseThatLackSomething) {
  const Soup soup = shapes::cube();
  const PreparedMesh mesh(soup);
  const std::vector<Field> fields = compute_fields(
      {.mesh = mesh},
      {FieldName::Area, FieldName::Defect, FieldName::K1, FieldName::Separation, FieldName::Area});
  ASSERT_EQ(fields.size(), 3U);
  EXPECT_EQ(fields[0].name, FieldName::Area);
  EXPECT_EQ(fields[1].name, FieldName::K1);
  EXPECT_EQ(fields[2].name, FieldName::Area);
  EXPECT_EQ(fields[0].values, fields[2].values);
}

TEST(ComputeFields, ValenceIsTheNumberOfNeighbours) {
  const Soup soup = shapes::merged(shapes::cube(), shapes::fan_of_three());
  const std::vector<double> valences = values_of(soup, FieldName::Valence);
  for (Index v = 0; v < soup.n_vertices(); ++v) {
    std::set<Index> neighbours;
    for (const Triangle& t : soup.triangles) {
      if (std::find(t.begin(), t.end(), v) != t.end()) {
        neighbours.insert(t.begin(), t.end());
      }
    }
    EXPECT_EQ(valences[v], static_cast<double>(neighbours.size() - 1));
  }
}

TEST(ComputeFields, VertexThatOnlyBadFacesUseHasNoValence) {
  Soup soup = cube_among_bad_records();
  soup.triangles[0] = {8, 7, 7};
  EXPECT_TRUE(std::isnan(values_of(soup, FieldName::Valence)[8]));
}

TEST(ComputeFields, HalfSquareHasHalfItsAreaAndAspectRatioTwo) {
  // Longest edge sqrt 2, shortest altitude 1 / sqrt 2.
  const Soup soup = cube_among_bad_records();
  const std::vector<double> areas = values_of(soup, FieldName::Area);
  const std::vector<double> ratios = values_of(soup, FieldName::AspectRatio);
  ASSERT_EQ(areas.size(), 14U);
  ASSERT_EQ(ratios.size(), 14U);
  for (std::size_t f = 0; f < areas.size(); ++f) {
    EXPECT_EQ(std::isnan(areas[f]), is_bad_record(f)) << f;
    EXPECT_EQ(std::isnan(ratios[f]), is_bad_record(f)) << f;
    if (!is_bad_record(f)) {
      EXPECT_DOUBLE_EQ(areas[f], 0.5);
      EXPECT_DOUBLE_EQ(ratios[f], 2.0);
    }
  }
}

TEST(ComputeFields, FaceOfZeroAreaHasAnInfiniteAspectRatio) {
  const Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  EXPECT_EQ(values_of(soup, FieldName::Area), (std::vector<double>{0}));
  EXPECT_EQ(values_of(soup, FieldName::AspectRatio), (std::vector<double>{kInfinity}));
}

TEST(ComputeFields, ComponentsCountFromTheFirstFaceOn) {
  Soup soup = shapes::merged(shapes::cube(), shapes::tetrahedron());
  std::reverse(soup.triangles.begin(), soup.triangles.end());
  std::vector<double> expected(16, 1.0);
  std::fill_n(expected.begin(), 4, 0.0);
  EXPECT_EQ(values_of(soup, FieldName::Component), expected);
}

TEST(ComputeFields, CubeIsCurvedByAQuarterOfPiTwiceOverTheFacesRoundEachCorner) {
  // The defect is pi / 2 at each corner; n half squares round it are n / 2, a third of them n / 6.
  const Soup soup = shapes::cube();
  const auto faces = faces_round_vertices(soup);
  const std::vector<double> whole = values_of(soup, FieldName::Gaussian, VertexArea::OneRing);
  const std::vector<double> third = values_of(soup, FieldName::Gaussian, VertexArea::Barycentric);
  for (std::size_t v = 0; v < 8; ++v) {
    const auto n = static_cast<double>(faces[v].size());
    EXPECT_NEAR(whole[v], std::numbers::pi / n, 1e-14);
    EXPECT_NEAR(third[v], 3 * std::numbers::pi / n, 1e-13);
  }
}

TEST(ComputeFields, CurvaturesAreThoseOfTheirNames) {
  const Soup soup = shapes::torus(3, 1, 12, 8);
  const PreparedMesh mesh(soup);
  const Curvature curvature = measure_curvature(mesh.cut(), VertexArea::Mixed);
  const std::vector<Field> fields = compute_fields(
      {.mesh = mesh}, {FieldName::Gaussian, FieldName::Mean, FieldName::K1, FieldName::K2});
  EXPECT_EQ(fields[0].values, curvature.gaussian);
  EXPECT_EQ(fields[1].values, curvature.mean);
  EXPECT_EQ(fields[2].values, curvature.k1);
  EXPECT_EQ(fields[3].values, curvature.k2);
  for (const Field& field : fields) {
    EXPECT_EQ(field.kind, FieldKind::Signed);
    EXPECT_EQ(field.place, FieldPlace::Vertices);
  }
}

TEST(ComputeFields, BorderHasNoCurvature) {
  const std::vector<double> values = values_of(shapes::open_cube(), FieldName::Gaussian);
  for (std::size_t v = 0; v < 8; ++v) {
    EXPECT_EQ(std::isnan(values[v]), v >= 4) << v;  // 4 ... 7 are those at z = 1
  }
}

Field separation_of(const Soup& soup, std::vector<double> distances) {
  const PreparedMesh mesh(soup);
  ObjectSeparation separation;
  separation.distances = std::move(distances);
  return compute_fields({.mesh = mesh, .separation = &separation}, {FieldName::Separation}).at(0);
}

TEST(ComputeFields, SeparationIsOfTheVerticesThatFacesUse) {
  const Soup soup = shapes::make({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {8, 8, 8}, {0, 1, 0}, {7, 7, 7}},
                                 {{4, 1, 2}, {3, 3, 1}, {5, 1, kNoIndex}});
  const Field field = separation_of(soup, {3, kNaN, 5});
  EXPECT_EQ(bits_of(field.values), bits_of({kNaN, 3, kNaN, kNaN, 5, kNaN}));
  EXPECT_EQ(field.kind, FieldKind::Magnitude);
}

TEST(ComputeFields, SeparationIsSignedWhereAVertexIsInside) {
  EXPECT_EQ(separation_of(shapes::tetrahedron(), {3, -0.5, 5, 2}).kind, FieldKind::Signed);
  EXPECT_EQ(separation_of(shapes::tetrahedron(), {-3, -0.5, -5, -2}).kind, FieldKind::Signed);
  EXPECT_EQ(separation_of(shapes::tetrahedron(), {3, 0, 5, 2}).kind, FieldKind::Magnitude);
}

TEST(ComputeFields, DefectIsOfFacesThatAreNotInTheComplexToo) {
  const Soup soup = cube_among_bad_records();
  const PreparedMesh mesh(soup);
  const DefectReport report = find_defects(mesh);
  const Field field = compute_fields({.mesh = mesh, .defects = &report}, {FieldName::Defect}).at(0);
  EXPECT_EQ(field.kind, FieldKind::Category);
  EXPECT_EQ(field.place, FieldPlace::Faces);
  EXPECT_EQ(field.values[0], 1.0 + static_cast<double>(DefectCode::DegenerateFacet));
  EXPECT_EQ(field.values[7], 1.0 + static_cast<double>(DefectCode::Corrupt));
}

TEST(ComputeFields, MeshWithAPositionThatIsNotFiniteIsRefused) {
  Soup soup = shapes::cube();
  soup.positions[0].x() = kNaN;
  const PreparedMesh mesh(soup);
  for (const FieldName name : computed_field_names()) {
    EXPECT_THROW(static_cast<void>(compute_fields({.mesh = mesh}, {name})), InvalidArgument);
  }
}

TEST(ComputeFields, MeshOfNothingHasFieldsOfNothing) {
  const Soup soup;
  const PreparedMesh mesh(soup);
  const DefectReport report = find_defects(mesh);
  const ObjectSeparation separation;
  const FieldSource source{.mesh = mesh, .defects = &report, .separation = &separation};
  const std::vector<Field> fields = compute_fields(source, computed_field_names());
  ASSERT_EQ(fields.size(), computed_field_names().size());
  for (const Field& field : fields) {
    EXPECT_TRUE(field.values.empty());
    EXPECT_TRUE(at_vertices(field, soup).empty());
  }
}

TEST(AtVertices, FieldOfVerticesStaysAsItIs) {
  const Field field{FieldName::Mean, FieldPlace::Vertices, FieldKind::Signed, {1, kNaN, 3, 4}};
  EXPECT_EQ(bits_of(at_vertices(field, shapes::tetrahedron())), bits_of(field.values));
}

TEST(AtVertices, AreasStayTheirTotal) {
  const Soup soup = shapes::torus(3, 1, 12, 8);
  const std::vector<double> areas = values_of(soup, FieldName::Area);
  const std::vector<double> thirds =
      at_vertices({FieldName::Area, FieldPlace::Faces, FieldKind::Magnitude, areas}, soup);
  EXPECT_NEAR(std::accumulate(thirds.begin(), thirds.end(), 0.0),
              std::accumulate(areas.begin(), areas.end(), 0.0), 1e-12);
  const auto faces = faces_round_vertices(soup);
  double round_first = 0.0;
  for (const std::size_t f : faces[0]) {
    round_first += areas[f];
  }
  EXPECT_NEAR(thirds[0], round_first / 3, 1e-14);
}

TEST(AtVertices, LargestValueOfTheFacesRoundAVertexCounts) {
  const Soup soup = cube_among_bad_records();
  std::vector<double> values(14);
  std::iota(values.begin(), values.end(), -20.0);
  values[9] = kInfinity;
  values[0] = kNaN;
  values[7] = kNaN;
  const std::vector<double> at =
      at_vertices({FieldName::AspectRatio, FieldPlace::Faces, FieldKind::Magnitude, values}, soup);
  const auto faces = faces_round_vertices(soup);
  for (std::size_t v = 0; v < 8; ++v) {
    double largest = -kInfinity;
    for (const std::size_t f : faces[v]) {
      largest = std::isnan(values[f]) ? largest : std::max(largest, values[f]);
    }
    EXPECT_EQ(at[v], largest);
  }
  EXPECT_TRUE(std::isnan(at[8]));
}

TEST(AtVertices, DefectOfAFaceWithoutACornerCountsAtTheCornersThatThereAre) {
  const Soup soup = cube_among_bad_records();
  std::vector<double> values(soup.n_faces(), 0.0);
  const double corrupt = 1.0 + static_cast<double>(DefectCode::Corrupt);
  values[7] = corrupt;
  EXPECT_EQ(bits_of(at_vertices({FieldName::Defect, FieldPlace::Faces, FieldKind::Category, values},
                                soup)),
            bits_of({corrupt, corrupt, 0, 0, 0, 0, 0, 0, kNaN}));
}

TEST(AtVertices, WorstDefectOfTheFacesRoundAVertexCounts) {
  // Faces 0 1 2 and 3 2 1: vertices 1 and 2 have both.
  const Soup soup =
      shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {3, 2, 1}});
  const auto value = [](DefectCode code) { return 1.0 + static_cast<double>(code); };
  const auto at = [&](double a, double b) {
    return at_vertices({FieldName::Defect, FieldPlace::Faces, FieldKind::Category, {a, b}}, soup);
  };
  const double warning = value(DefectCode::Disjoint);
  const double error = value(DefectCode::Hole);
  EXPECT_EQ(at(warning, error), (std::vector<double>{warning, error, error, error}));
  EXPECT_EQ(at(error, warning), (std::vector<double>{error, error, error, warning}));
  EXPECT_EQ(at(0, warning), (std::vector<double>{0, warning, warning, warning}));
  EXPECT_EQ(at(error, value(DefectCode::Flipped)),
            (std::vector<double>{error, error, error, value(DefectCode::Flipped)}));
}

}  // namespace
}  // namespace meshalyzer
