#include "meshalyzer/arrangement/arrange.h"
#include "meshalyzer/exact/exact_point.h"
#include "meshalyzer/repair/cut/internal/cut_surface.h"
#include "meshalyzer/repair/cut/internal/select_pieces.h"
#include "support/arranged_mesh.h"
#include "support/effort.h"
#include "support/random_soups.h"
#include "support/shapes.h"
#include "support/solid_moments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

using test::Moments;
using test::Rational;
using test::RationalCorners;
using test::RationalPoint;

std::vector<RationalCorners> triangles_of(const std::vector<RationalPoint>& places,
                                          const std::vector<Triangle>& triangles) {
  std::vector<RationalCorners> result;
  for (const auto& [a, b, c] : triangles) result.push_back({places[a], places[b], places[c]});
  return result;
}

std::vector<RationalPoint> rational_places(const std::vector<Vec3>& positions) {
  std::vector<RationalPoint> places;
  for (const Vec3& p : positions) places.push_back(test::rational_point(p));
  return places;
}

std::vector<RationalPoint> rational_places(const Arrangement& a) {
  std::vector<RationalPoint> places = rational_places(a.positions);
  for (std::size_t v = a.n_input_vertices; v < places.size(); ++v) {
    const ExactPoint& exact = a.exact.made(v - a.n_input_vertices);
    const Rational w(exact.denominator);
    places[v] = {Rational(exact.numerator[0]) / w, Rational(exact.numerator[1]) / w,
                 Rational(exact.numerator[2]) / w};
  }
  return places;
}

/// Returns the moments of the region with a winding number of at least one, by brute force over
/// the rationals.
Moments true_moments(const Soup& soup) {
  return test::moments_inside(triangles_of(rational_places(soup.positions), soup.triangles));
}

/// What the pieces enclose that are kept of a closed chain, before anything is rounded; nothing
/// where the chain falls into several components, of which each is kept.
std::optional<Moments> kept_moments(const Soup& soup) {
  const test::ArrangedMesh mesh(soup);
  const Arrangement& arrangement = mesh.arrangement;
  if (mesh.cells.n_components != 1) return std::nullopt;
  const std::vector<PieceClass> classes =
      select_pieces(mesh.arranged, std::vector<std::uint8_t>{1}, {});
  std::vector<Triangle> kept;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    Triangle t = arrangement.pieces[i];
    if (classes[i] == PieceClass::Turned) std::swap(t[1], t[2]);
    if (classes[i] == PieceClass::Kept || classes[i] == PieceClass::Turned) kept.push_back(t);
  }
  return test::moments_enclosed(triangles_of(rational_places(arrangement), kept));
}

/// Returns the moments of the solid that is left after all rounds of cutting and rounding.
Moments cut_moments(const Soup& soup) {
  const TrackedMesh tracked = track_mesh(soup);
  const PreparedMesh mesh(tracked.soup);
  const Tolerances tolerances;
  const RepairLimits limits{.max_deviation = 1e-9, .fixed_vertices = {}};
  const CutSurface surface =
      cut_surface({soup, tracked, mesh, tolerances, limits}, {}, {}, {ThinFacets::Kept});
  EXPECT_TRUE(surface.unfinished.empty());
  return test::moments_enclosed(
      triangles_of(rational_places(surface.positions), surface.triangles));
}

/// @param extent  The largest coordinate: moments are at most its fourth power, times some ten, and
/// each rounded coordinate is off by 1e-16 of it.
void expect_near(const Moments& found, const Moments& truth, double extent) {
  for (std::size_t k = 0; k < truth.size(); ++k) {
    EXPECT_LE(std::abs(CGAL::to_double(found[k] - truth[k])), 1e-12 * std::pow(extent, 4)) << k;
  }
}

/// The boundaries of tetrahedra that stand on some points of a grid, and have corners, edges and
/// faces in common. Most are turned outward, so that more is gone round once than minus once.
Soup random_chain(std::mt19937& random, Index n_points, Index n_tetrahedra) {
  constexpr Index kGrid = 5;
  Soup soup;
  for (Index i = 0; i < n_points; ++i) {
    soup.positions.emplace_back(below(random, kGrid), below(random, kGrid), below(random, kGrid));
  }
  while (soup.n_faces() < 4 * std::size_t{n_tetrahedra}) {
    std::array<Index, 4> v{};
    for (Index& corner : v) corner = below(random, n_points);
    const auto& p = soup.positions;
    const double volume = (p[v[1]] - p[v[0]]).cross(p[v[2]] - p[v[0]]).dot(p[v[3]] - p[v[0]]);
    if (volume == 0.0) continue;
    const bool is_outward = below(random, 8) != 0;
    if ((volume > 0.0) == is_outward) std::swap(v[0], v[1]);
    for (const Triangle& t : {Triangle{v[0], v[1], v[2]}, Triangle{v[0], v[3], v[1]},
                              Triangle{v[1], v[3], v[2]}, Triangle{v[2], v[3], v[0]}}) {
      soup.triangles.push_back(t);
    }
  }
  return soup;
}

TEST(CutLaws, BruteForceKnowsTheMomentsOfBoxes) {
  // [0, 2]^3 with [1, 4] x [1, 2] x [0, 1], of which [1, 2]^2 x [0, 1] is in common: 8 + 3 - 1.
  Soup bar = shapes::cube(1, {1, 1, 0});
  for (Vec3& p : bar.positions) p.x() = p.x() == 1.0 ? 1.0 : 4.0;
  const Moments moments = true_moments(shapes::merged(shapes::cube(2), bar));
  // By x: 8 * 1 + 3 * 2.5 - 1 * 1.5; by y: 8 * 1 + 3 * 1.5 - 1 * 1.5; by z: 8 * 1 + 2 * 0.5.
  EXPECT_EQ(moments, (Moments{10, 14, 11, 9}));
  // Inside out nothing is gone round once.
  EXPECT_EQ(true_moments(shapes::flipped(shapes::cube())), (Moments{0, 0, 0, 0}));
}

TEST(CutLaws, KeptPiecesOfRandomChainsEncloseWhatBruteForceSays) {
  std::mt19937 random(20261122);
  test::Effort effort;
  int n_compared = 0;
  for (int i = 0; i < 40; ++i) {
    const Soup soup = random_chain(random, 5 + below(random, 5), 2 + below(random, 5));
    if (!effort.runs_next()) continue;
    const std::optional<Moments> kept = kept_moments(soup);
    const Moments truth = true_moments(soup);
    // Something may be kept although no region has a winding number of one.
    if (!kept || truth[0] == 0) continue;
    EXPECT_EQ(*kept, truth) << i;
    SCOPED_TRACE(i);
    // Where nothing intersects nothing is cut, be it inside out or not.
    if (PreparedMesh(soup).intersecting_pairs().empty()) continue;
    expect_near(cut_moments(soup), truth, 5.0);
    ++n_compared;
  }
  EXPECT_GE(n_compared, 20 / static_cast<int>(test::one_of()));
}

TEST(CutLaws, BoxesThatCrossAskewBecomeTheirUnion) {
  std::mt19937 random(7);
  test::Effort effort;
  // Coordinates of few bits, for the sake of brute force.
  const auto share = [&] { return below(random, 9) / 8.0; };
  for (int i = 0; i < 4; ++i) {
    Soup soup;
    for (int n = 0; n < 2; ++n) {
      // A box sheared at will.
      Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
      for (int k = 0; k < 9; ++k) shear(k / 3, k % 3) += 0.5 * share();
      Soup box = shapes::cube(1, {-0.5, -0.5, -0.5});
      for (Vec3& p : box.positions) p = Vec3(shear * p + 0.25 * Vec3(share(), share(), share()));
      soup = n == 0 ? box : shapes::merged(std::move(soup), box);
    }
    if (!effort.runs_next()) continue;
    const std::optional<Moments> kept = kept_moments(soup);
    ASSERT_TRUE(kept) << "all contain the origin";
    const Moments truth = true_moments(soup);
    EXPECT_EQ(*kept, truth) << i;
    expect_near(cut_moments(soup), truth, 2.0);
  }
}

}  // namespace
}  // namespace meshalyzer
