#include "meshalyzer/geometry/curvature.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/build.h"
#include "soups_to_try.h"
#include "support/constants.h"
#include "support/curved_shapes.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

using shapes::CurvedShape;
using shapes::Meshing;
using shapes::Surface;

constexpr std::uint32_t kNumberingSeed = 5;
/// Sums in another order differ by some units in the last place, which dividing by the square of an
/// edge of 1/20 makes a thousand times as large.
constexpr double kCurvatureRounding = 1e-10;

Curvature curvature_of(const Soup& soup) {
  return measure_curvature(build(soup));
}

std::string name_of(Surface surface, Meshing meshing) {
  std::string name(shapes::surface_name(surface));
  name += ", ";
  name += shapes::meshing_name(meshing);
  return name;
}

/// V - E + F of the faces of a complex.
std::int64_t euler_number(const Soup& soup) {
  std::set<Index> vertices;
  std::set<std::pair<Index, Index>> edges;
  std::int64_t faces = 0;
  for (const Triangle& t : soup.triangles) {
    if (!is_in_complex(t)) continue;
    ++faces;
    for (std::size_t i = 0; i < 3; ++i) {
      vertices.insert(t[i]);
      edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
    }
  }
  return static_cast<std::int64_t>(vertices.size()) - static_cast<std::int64_t>(edges.size()) +
         faces;
}

void expect_gauss_bonnet(const Soup& soup) {
  const Curvature curvature = curvature_of(soup);
  double sum = 0.0;
  for (std::size_t v = 0; v < curvature.state.size(); ++v) {
    if (curvature.state[v] != CurvatureState::Unused) sum += curvature.angle_defect[v];
  }
  // Each angle is right to a few units in the last place of pi, and so are the sums of them.
  const double rounding = 1e-14 * (1.0 + static_cast<double>(soup.n_faces()));
  EXPECT_NEAR(sum, 2 * kPi * static_cast<double>(euler_number(soup)), rounding);
}

/// Moved at random, each coordinate by up to 0.3.
Soup jittered(Soup soup, std::mt19937& random) {
  for (Vec3& p : soup.positions) {
    for (double& x : p) {
      x += 0.6 * (static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 0.5);
    }
  }
  return soup;
}

TEST(GaussBonnetLaw, HoldsOnEverySoup) {
  for (const NamedSoup& each : soups_to_try()) {
    SCOPED_TRACE(each.name);
    expect_gauss_bonnet(each.soup);
  }
}

TEST(GaussBonnetLaw, HoldsOnRandomClosedSurfacesOfEveryGenus) {
  std::mt19937 random(kNumberingSeed);
  for (std::size_t genus = 0; genus < 30; ++genus) {
    SCOPED_TRACE(genus);
    const Soup soup = jittered(shapes::genus_block(genus), random);
    ASSERT_EQ(euler_number(soup), 2 - 2 * static_cast<std::int64_t>(genus));
    expect_gauss_bonnet(soup);
  }
}

/// Root mean squares of errors over the vertices that have a curvature.
struct Errors {
  double gaussian = 0.0;
  double mean = 0.0;
  double principal = 0.0;
};

Errors errors_of(const CurvedShape& shape) {
  const Curvature c = curvature_of(shape.soup);
  Errors sum;
  double n = 0.0;
  for (std::size_t v = 0; v < c.state.size(); ++v) {
    if (c.state[v] != CurvatureState::Defined) continue;
    const shapes::TrueCurvature& truth = shape.truth[v];
    sum.gaussian += std::pow(c.gaussian[v] - truth.gaussian, 2);
    sum.mean += std::pow(c.mean[v] - truth.mean, 2);
    sum.principal += std::pow(c.k1[v] - truth.k1, 2) / 2 + std::pow(c.k2[v] - truth.k2, 2) / 2;
    n += 1.0;
  }
  return {std::sqrt(sum.gaussian / n), std::sqrt(sum.mean / n), std::sqrt(sum.principal / n)};
}

/// Every edge halved: errors of second order fall to a quarter, of first order to a half. A tenth
/// is left for what is of higher order, and `rounding` for what is no error of the method.
void expect_order(double coarse, double fine, double order) {
  EXPECT_LE(fine, coarse * std::pow(2.0, -order) * 1.1 + kCurvatureRounding);
}

TEST(CurvatureError, AllFallsWithTheSquareOfTheEdgeLengthOnRegularGrids) {
  // Where the faces round a vertex are the same as those opposite to them, what is odd in the
  // expansion of the surface cancels. The normals at borders, which see one side, cost half an
  // order of the principal curvatures.
  for (const Surface surface :
       {Surface::Torus, Surface::Cylinder, Surface::Catenoid, Surface::MonkeySaddle}) {
    SCOPED_TRACE(name_of(surface, Meshing::Regular));
    const Errors coarse = errors_of(curved_shape(surface, Meshing::Regular, 2));
    const Errors fine = errors_of(curved_shape(surface, Meshing::Regular, 3));
    expect_order(coarse.gaussian, fine.gaussian, 2.0);
    expect_order(coarse.mean, fine.mean, 2.0);
    expect_order(coarse.principal, fine.principal, surface == Surface::Torus ? 2.0 : 1.5);
  }
}

TEST(CurvatureError, PrincipalFallsWithTheEdgeLengthOnIrregularMeshes) {
  // Normals right to the square of the edge length h, differentiated: an error of h. The angle
  // defect and the cotangent vector do not get better on such meshes, only their averages do.
  for (const Surface surface : shapes::kSurfaces) {
    SCOPED_TRACE(name_of(surface, Meshing::Irregular));
    const Errors coarse = errors_of(curved_shape(surface, Meshing::Irregular, 2));
    const Errors fine = errors_of(curved_shape(surface, Meshing::Irregular, 3));
    expect_order(coarse.principal, fine.principal, 1.0);
  }
}

TEST(CurvatureError, IsSmallWhereEdgesAreATenthOfTheSize) {
  // Second-order terms are k (k h)^2 / 4 or so. Level 3 has edges h of 0.06 to 0.2, curvatures k
  // are up to 1: 0.01 of error. At the tips of the ellipsoid, where k is 2.7, they are 0.2.
  for (const Surface surface : shapes::kSurfaces) {
    SCOPED_TRACE(name_of(surface, Meshing::Regular));
    const Errors errors = errors_of(curved_shape(surface, Meshing::Regular, 3));
    EXPECT_LT(errors.gaussian, 0.02);
    EXPECT_LT(errors.mean, 0.02);
    EXPECT_LT(errors.principal, surface == Surface::Ellipsoid ? 0.16 : 0.02);
  }
}

TEST(CurvatureError, PrincipalSurvivesNoise) {
  // Noise of 0.01 h turns the normal of a face by about 0.01, which over an edge of h = 0.1 looks
  // like a curvature of 0.1; the fit over some twenty vertices leaves a third of that.
  for (const Surface surface : shapes::kSurfaces) {
    SCOPED_TRACE(name_of(surface, Meshing::Noisy));
    const Errors clean = errors_of(curved_shape(surface, Meshing::Irregular, 3));
    const Errors noisy = errors_of(curved_shape(surface, Meshing::Noisy, 3));
    EXPECT_LT(noisy.principal, clean.principal + 0.035);
  }
}

TEST(CurvatureError, MeanOfASphereByVoronoiCellsIsWithinThreePerMille) {
  const Soup sphere = shapes::icosphere(4);
  const Curvature c = measure_curvature(build(sphere), VertexArea::Voronoi);
  double sum = 0.0;
  for (const double mean : c.mean) sum += mean;
  EXPECT_NEAR(sum / static_cast<double>(c.mean.size()), 1.0, 0.003);
}

/// Tells whether two unit tangents are the same or opposite, where k1 and k2 tell them apart.
void expect_same_line(const Vec3& a, const Vec3& b) {
  EXPECT_LT(a.cross(b).norm(), 1e-7);
}

/// Where directions are compared: nearer to each other, rounding turns them.
bool has_directions(const Curvature& c, std::size_t v) {
  return c.k1[v] - c.k2[v] > 0.01;
}

/// A second mesh of the same surface: where each vertex is, and how directions are turned.
struct Image {
  Soup soup;
  std::vector<Index> vertex;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
};

void expect_same_curvature(const Soup& soup, const Image& image) {
  const Curvature a = curvature_of(soup);
  const Curvature b = curvature_of(image.soup);
  for (std::size_t v = 0; v < a.state.size(); ++v) {
    const Index w = image.vertex[v];
    ASSERT_EQ(a.state[v], b.state[w]);
    EXPECT_NEAR(a.angle_defect[v], b.angle_defect[w], kCurvatureRounding);
    if (a.state[v] != CurvatureState::Defined) continue;
    EXPECT_NEAR(a.gaussian[v], b.gaussian[w], kCurvatureRounding);
    EXPECT_NEAR(a.mean[v], b.mean[w], kCurvatureRounding);
    EXPECT_NEAR(a.k1[v], b.k1[w], kCurvatureRounding);
    EXPECT_NEAR(a.k2[v], b.k2[w], kCurvatureRounding);
    if (!has_directions(a, v)) continue;
    expect_same_line(image.turn * a.direction1[v], b.direction1[w]);
    expect_same_line(image.turn * a.direction2[v], b.direction2[w]);
    if (testing::Test::HasFailure()) return;
  }
}

std::vector<CurvedShape> shapes_to_try() {
  std::vector<CurvedShape> all;
  for (const Surface surface : shapes::kSurfaces) {
    for (const Meshing meshing : {Meshing::Irregular, Meshing::Noisy}) {
      all.push_back(curved_shape(surface, meshing, 2));
    }
  }
  return all;
}

std::vector<Index> same_vertices(const Soup& soup) {
  std::vector<Index> all(soup.n_vertices());
  for (std::size_t v = 0; v < all.size(); ++v) all[v] = static_cast<Index>(v);
  return all;
}

TEST(CurvatureLaw, RenumberingAndShufflingChangesNothing) {
  for (const CurvedShape& shape : shapes_to_try()) {
    Image image;
    image.soup = shapes::shuffled_faces(shapes::renumbered_vertices(shape.soup, kNumberingSeed),
                                        kNumberingSeed);
    image.vertex = shapes::permutation(shape.soup.n_vertices(), kNumberingSeed);
    expect_same_curvature(shape.soup, image);
  }
}

TEST(CurvatureLaw, MovingAndTurningTheMeshTurnsOnlyDirections) {
  for (const CurvedShape& shape : shapes_to_try()) {
    Image image{.soup = shape.soup, .vertex = same_vertices(shape.soup)};
    image.turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (Vec3& p : image.soup.positions) p = (image.turn * p + Vec3(0.3, -0.4, 0.5)).eval();
    expect_same_curvature(shape.soup, image);
  }
}

TEST(CurvatureLaw, TurningAllFacesOverTurnsSigns) {
  for (const CurvedShape& shape : shapes_to_try()) {
    const Curvature a = curvature_of(shape.soup);
    const Curvature b = curvature_of(shapes::flipped(shape.soup));
    for (std::size_t v = 0; v < a.state.size(); ++v) {
      ASSERT_EQ(a.state[v], b.state[v]);
      if (a.state[v] != CurvatureState::Defined) continue;
      EXPECT_NEAR(a.gaussian[v], b.gaussian[v], kCurvatureRounding);
      EXPECT_NEAR(a.mean[v], -b.mean[v], kCurvatureRounding);
      EXPECT_NEAR(a.k1[v], -b.k2[v], kCurvatureRounding);
      EXPECT_NEAR(a.k2[v], -b.k1[v], kCurvatureRounding);
      if (has_directions(a, v)) expect_same_line(a.direction1[v], b.direction2[v]);
      if (testing::Test::HasFailure()) return;
    }
  }
}

template <typename T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST(CurvatureLaw, IsTheSameByteForByteOnAnyNumberOfThreads) {
  // 18,432 vertices: three chunks of a parallel loop.
  const CutMesh cut = build(curved_shape(Surface::Torus, Meshing::Noisy, 4).soup);
  ASSERT_GT(n_chunks(cut.mesh.n_vertices()), 2U);
  const auto on_threads = [&](std::size_t n) {
    const ThreadLimit limit(n);
    return measure_curvature(cut);
  };
  const Curvature one = on_threads(1);
  for (const std::size_t threads : {2U, 3U, 4U}) {
    const Curvature many = on_threads(threads);
    EXPECT_TRUE(same_bytes(one.angle_defect, many.angle_defect));
    EXPECT_TRUE(same_bytes(one.gaussian, many.gaussian));
    EXPECT_TRUE(same_bytes(one.mean, many.mean));
    EXPECT_TRUE(same_bytes(one.k1, many.k1));
    EXPECT_TRUE(same_bytes(one.k2, many.k2));
    EXPECT_TRUE(same_bytes(one.direction1, many.direction1));
    EXPECT_TRUE(same_bytes(one.direction2, many.direction2));
  }
}

/// Expects a closed form at points of a surface.
template <typename Gaussian, typename Mean>
void expect_truth(Surface surface, const Gaussian& gaussian, const Mean& mean) {
  const CurvedShape shape = curved_shape(surface, Meshing::Irregular, 1);
  for (std::size_t v = 0; v < shape.truth.size(); ++v) {
    const Vec3& p = shape.soup.positions[v];
    EXPECT_NEAR(shape.truth[v].gaussian, gaussian(p), 1e-13);
    EXPECT_NEAR(shape.truth[v].mean, mean(p), 1e-13);
    EXPECT_NEAR(shape.truth[v].k1 * shape.truth[v].k2, gaussian(p), 1e-13);
  }
}

TEST(TrueCurvature, IsWhatTextbooksSay) {
  const auto zero = [](const Vec3&) { return 0.0; };
  const auto one = [](const Vec3&) { return 1.0; };
  expect_truth(Surface::Sphere, one, one);
  expect_truth(Surface::Cylinder, zero, [](const Vec3&) { return 0.5; });
  // K = -1 / cosh^4 z.
  expect_truth(
      Surface::Catenoid, [](const Vec3& p) { return -std::pow(std::cosh(p.z()), -4); }, zero);
  // cos t / (R + r cos t) round the axis, 1 / r = 1 round the tube; R + r cos t is the distance
  // from the axis.
  const auto round_axis = [](const Vec3& p) { return 1 - 2 / std::hypot(p.x(), p.y()); };
  expect_truth(Surface::Torus, round_axis, [&](const Vec3& p) { return (1 + round_axis(p)) / 2; });
  // K = 1 / (a^2 b^2 c^2 (x^2/a^4 + y^2/b^4 + z^2/c^4)^2), and with s its inner sum
  // H = (a^2 + b^2 + c^2 - x^2 - y^2 - z^2) / (2 a^2 b^2 c^2 s^(3/2)).
  const Vec3 squares(2.25, 1.0, 0.5625);
  const auto inner = [=](const Vec3& p) { return p.cwiseQuotient(squares).squaredNorm(); };
  expect_truth(
      Surface::Ellipsoid, [=](const Vec3& p) { return 1 / squares.prod() / std::pow(inner(p), 2); },
      [=](const Vec3& p) {
        return (squares.sum() - p.squaredNorm()) / (2 * squares.prod() * std::pow(inner(p), 1.5));
      });
  // z = f: K = (f_xx f_yy - f_xy^2) / (1 + |grad f|^2)^2, where |grad f| = r^2, second derivatives
  // 2x, -2y, -2x; H = -((1 + f_y^2) f_xx - 2 f_x f_y f_xy + (1 + f_x^2) f_yy) / 2 (1 + r^4)^1.5.
  const auto gradient = [](const Vec3& p) {
    return Eigen::Vector2d(p.x() * p.x() - p.y() * p.y(), -2 * p.x() * p.y());
  };
  expect_truth(
      Surface::MonkeySaddle,
      [=](const Vec3& p) {
        return -4 * p.head<2>().squaredNorm() / std::pow(1 + gradient(p).squaredNorm(), 2);
      },
      [=](const Vec3& p) {
        const Eigen::Vector2d g = gradient(p);
        const double sum = (1 + g.y() * g.y()) * 2 * p.x() + 4 * g.x() * g.y() * p.y() -
                           (1 + g.x() * g.x()) * 2 * p.x();
        return -sum / (2 * std::pow(1 + g.squaredNorm(), 1.5));
      });
}

}  // namespace
}  // namespace meshalyzer
