#include "cell_model.h"
#include "meshalyzer/arrangement/arrange.h"
#include "meshalyzer/arrangement/cells.h"
#include "meshalyzer/boolean/combine_solids.h"
#include "meshalyzer/boolean/internal/boundary_pieces.h"
#include "meshalyzer/exact/exact_point.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/self_intersection.h"
#include "support/boolean_results.h"
#include "support/constants.h"
#include "support/effort.h"
#include "support/rational_figures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <random>
#include <set>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

using test::analyzed;
using test::combined;
using test::places_of;
using test::Rational;
using test::RationalPoint;
using test::rotated;
using test::verdict_on;
using test::volume_of;

/// The result of a boolean operation before anything is rounded.
struct ExactSolid {
  Arrangement arrangement;
  std::vector<BoundaryPiece> boundary;
};

/// Several meshes, and what any rule makes of them before anything is rounded.
class ExactOperands {
 public:
  explicit ExactOperands(const std::vector<Soup>& meshes)
      : soup_(concatenate(meshes)),
        operands_(operands_of(soup_, meshes)),
        cut_(build(soup_)),
        tree_(cut_),
        pairs_(find_self_intersections(cut_, tree_)) {}

  [[nodiscard]] ExactSolid combine(const InsideRule& rule) const {
    Arrangement arrangement = arrange(soup_, pairs_);
    const Cells cells = find_cells(soup_, arrangement);
    std::vector<BoundaryPiece> boundary = find_boundary_pieces(
        {soup_, cut_, tree_, arrangement, cells}, operands_.of_face, operands_.count, rule);
    return {std::move(arrangement), std::move(boundary)};
  }

  /// The volume of what a rule makes of them.
  [[nodiscard]] Rational volume(const InsideRule& rule) const { return volume(combine(rule)); }

  [[nodiscard]] Rational volume(const ExactSolid& solid) const {
    std::vector<RationalPoint> places;
    for (std::size_t v = 0; v < solid.arrangement.positions.size(); ++v) {
      places.push_back(place(solid.arrangement, v));
    }
    Rational six_times = 0;
    for (const BoundaryPiece& part : solid.boundary) {
      const auto& [a, b, c] = solid.arrangement.pieces[part.piece];
      const Rational det = CGAL::determinant(places[a] - CGAL::ORIGIN, places[b] - CGAL::ORIGIN,
                                             places[c] - CGAL::ORIGIN);
      six_times += part.is_turned ? -det : det;
    }
    return six_times / 6;
  }

 private:
  [[nodiscard]] static RationalPoint place(const Arrangement& a, std::size_t v) {
    if (v < a.n_input_vertices) return test::rational_point(a.positions[v]);
    const ExactPoint& exact = a.exact.made(v - a.n_input_vertices);
    const Rational w(exact.denominator);
    return {Rational(exact.numerator[0]) / w, Rational(exact.numerator[1]) / w,
            Rational(exact.numerator[2]) / w};
  }

  Soup soup_;
  Operands operands_;
  CutMesh cut_;
  FaceTree tree_;
  std::vector<IntersectingPair> pairs_;
};

/// Vertices less edges plus faces.
int euler_characteristic(const ExactSolid& solid) {
  std::set<Index> vertices;
  std::set<std::pair<Index, Index>> edges;
  for (const BoundaryPiece& part : solid.boundary) {
    const Triangle& t = solid.arrangement.pieces[part.piece];
    for (std::size_t k = 0; k < 3; ++k) {
      vertices.insert(t[k]);
      edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
    }
  }
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(solid.boundary.size());
}

/// The 27 ways in which an interval of length 1, 2 or 3 can lie to [3, 6], on a grid.
std::array<int, 2> grid_interval(std::size_t i) {
  const auto low = static_cast<int>(i % 9);
  return {low, low + static_cast<int>(1 + i / 9)};
}

std::vector<InsideRule> all_rules() {
  return {union_rule(), intersection_rule(), difference_rule()};
}

TEST(BooleanLaws, TwoBoxesInAllIntegerRelationsHaveTheVolumeAndTopologyOfTheirCells) {
  constexpr std::size_t kShare = 37;
  const CellModel::Box first{{{3, 6}, {3, 6}, {3, 6}}};
  for (std::size_t i = 0; i < 27 * 27 * 27; i += kShare * test::one_of()) {
    const CellModel::Box second{grid_interval(i % 27), grid_interval(i / 27 % 27),
                                grid_interval(i / 27 / 27)};
    const ExactOperands boxes({box_mesh(first), box_mesh(second)});
    for (const InsideRule& rule : all_rules()) {
      const CellModel model({first, second}, rule);
      const ExactSolid solid = boxes.combine(rule);
      ASSERT_EQ(boxes.volume(solid), Rational(model.volume())) << i;
      ASSERT_EQ(euler_characteristic(solid), model.euler_characteristic()) << i;
    }
  }
}

TEST(BooleanLaws, UnionAndIntersectionTogetherHaveTheVolumeOfBoth) {
  const Soup torus = shapes::torus(1, 0.4, 20, 12);
  std::mt19937 random(16);
  std::uniform_real_distribution<double> uniform(-1, 1);
  test::Effort effort;
  for (int i = 0; i < 30; ++i) {
    const Vec3 axis(uniform(random), uniform(random), uniform(random));
    const Soup other = rotated(torus, uniform(random) * 3, axis);
    if (!effort.runs_next()) continue;
    const ExactOperands both({torus, other});
    const Rational whole = ExactOperands({torus}).volume(union_rule());
    EXPECT_EQ(both.volume(union_rule()) + both.volume(intersection_rule()),
              whole + ExactOperands({other}).volume(union_rule()))
        << i;
    EXPECT_EQ(both.volume(difference_rule()) + both.volume(intersection_rule()), whole) << i;
    for (const InsideRule& rule : all_rules()) {
      EXPECT_EQ(verdict_on(combined({torus, other}, rule)), "good") << i;
    }
  }
}

TEST(BooleanLaws, SpheresHaveTheVolumesOfTheirClosedForms) {
  const Soup sphere = shapes::icosphere(5);
  for (const double d : {0.3, 1.0, 1.7}) {
    const std::vector<Soup> both{sphere, shapes::translated(sphere, {d, 0.01, 0.02})};
    const double apart = Vec3(d, 0.01, 0.02).norm();
    const double lens = kPi * (4 + apart) * (2 - apart) * (2 - apart) / 12;
    const double whole = 4 * kPi / 3;
    // An inscribed icosphere of this level lacks one part in a thousand of its volume.
    EXPECT_NEAR(volume_of(combined(both, intersection_rule())), lens, 0.004 * lens + 0.001);
    EXPECT_NEAR(volume_of(combined(both, union_rule())), 2 * whole - lens, 0.002 * 2 * whole);
    EXPECT_NEAR(volume_of(combined(both, difference_rule())), whole - lens, 0.005 * whole);
  }
}

TEST(BooleanLaws, MeshCombinedWithItselfAndWithAPermutedCopyIsItself) {
  const Soup block = shapes::genus_block(2);
  const Soup permuted = shapes::renumbered_vertices(shapes::shuffled_faces(block, 3), 4);
  for (const Soup& copy : {block, permuted}) {
    EXPECT_EQ(places_of(combined({block, copy}, union_rule())), places_of(block));
    EXPECT_EQ(places_of(combined({block, copy}, intersection_rule())), places_of(block));
    EXPECT_TRUE(combined({block, copy}, difference_rule()).triangles.empty());
  }
}

TEST(BooleanLaws, OutputCombinedAgainChangesNothing) {
  const Soup once = combined({shapes::icosphere(3), shapes::torus(1, 0.4, 30, 16)}, union_rule());
  EXPECT_EQ(places_of(combined({once}, union_rule())), places_of(once));
}

TEST(BooleanLaws, TwentyCubesThatSharePlanesBecomeOneBox) {
  std::vector<Soup> cubes;
  // Each has a face in common with the next one, or half of it.
  for (int i = 0; i < 20; ++i) cubes.push_back(shapes::cube(2, {2.0 * i, i % 2 * 1.0, 0}));
  const ExactOperands operands(cubes);
  const ExactSolid solid = operands.combine(union_rule());
  EXPECT_EQ(operands.volume(solid), Rational(160));
  EXPECT_EQ(euler_characteristic(solid), 2);
  EXPECT_EQ(verdict_on(combined(cubes, union_rule())), "good");
}

TEST(BooleanLaws, TwentyByTwentyRodsBecomeAGrate) {
  std::vector<Soup> rods;
  for (int i = 0; i < 20; ++i) {
    rods.push_back(box_mesh({{{-1, 41}, {2 * i, 2 * i + 1}, {0, 1}}}));
    rods.push_back(box_mesh({{{2 * i, 2 * i + 1}, {-1, 41}, {0, 1}}}));
  }
  const ExactOperands operands(rods);
  const ExactSolid solid = operands.combine(union_rule());
  // 40 rods of length 42, of which 400 unit cubes are in two; 19 x 19 holes.
  EXPECT_EQ(operands.volume(solid), Rational(40 * 42 - 400));
  EXPECT_EQ(euler_characteristic(solid), 2 - 2 * 361);
  EXPECT_EQ(verdict_on(combined(rods, union_rule())), "good");
}

TEST(BooleanLaws, RodsInThreeDirectionsThatCrossAskewAreUnited) {
  std::vector<Soup> rods;
  for (int i = 0; i < 6; ++i) {
    const Soup rod = box_mesh({{{-9, 9}, {i - 3, i - 2}, {0, 1}}});
    rods.push_back(rotated(rod, 0.1 * i, {0.3, 0.2, 1}));
    rods.push_back(rotated(rod, 0.1 * i + 1, {1, 0.5, 0.1}));
  }
  const ExactOperands operands(rods);
  const double exact = CGAL::to_double(operands.volume(union_rule()));
  const Soup all = combined(rods, union_rule());
  EXPECT_NEAR(volume_of(all), exact, 1e-9 * exact);
  EXPECT_EQ(verdict_on(all), "good");
}

TEST(BooleanLaws, SolidTakenOutOfTheMiddleLeavesACavity) {
  const Soup hollow = combined({shapes::icosphere(3), shapes::scaled(shapes::icosphere(2), 0.5)},
                               difference_rule());
  const Analysis analysis = analyzed(hollow);
  EXPECT_EQ(verdict_text(*analysis.fitness), "good");
  EXPECT_EQ(analysis.components.size(), 2U);
  // And filled again it is full, but for the wall, which goes.
  const Soup full = combined({hollow, shapes::scaled(shapes::icosphere(2), 0.5)}, union_rule());
  EXPECT_EQ(places_of(full), places_of(shapes::icosphere(3)));
}

TEST(BooleanLaws, DifferenceMakesAHoleThrough) {
  const Soup rod =
      rotated(shapes::scaled(shapes::cube(1, {-0.5, -0.5, -0.5}), 0.6), 0.4, {1, 2, 3});
  Soup longer = rod;
  for (Vec3& p : longer.positions) p.z() *= 10;
  const Analysis analysis = analyzed(combined({shapes::icosphere(4), longer}, difference_rule()));
  EXPECT_EQ(verdict_text(*analysis.fitness), "good");
  EXPECT_EQ(analysis.characteristics.genus.value, 1);
}

TEST(BooleanLaws, ThirtyRotatedCopiesOfAMeshAreUnitedEach) {
  const std::filesystem::path bunny =
      std::filesystem::path(MESHALYZER_CORPUS) / "lab/bunnySmall.obj";
  const Soup mesh = std::filesystem::exists(bunny)
                        ? read_mesh(bunny.string())
                        : read_mesh(std::string(MESHALYZER_MESHES) + "/genus_3.mesh");
  test::Effort effort;
  for (int i = 1; i <= 30; ++i) {
    if (!effort.runs_next()) continue;
    const Soup turned = rotated(mesh, 0.2 * i, {1, 0.3 * i, 2});
    EXPECT_EQ(verdict_on(combined({mesh, turned}, union_rule())), "good") << i;
  }
}

}  // namespace
}  // namespace meshalyzer
