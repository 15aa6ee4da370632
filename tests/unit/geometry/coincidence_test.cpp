#include "meshalyzer/geometry/coincidence.h"

#include "support/effort.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

std::vector<Index> compare_all_pairs(const std::vector<Vec3>& positions, Coincidence coincidence) {
  std::vector<Index> found;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (std::size_t j = 0; j < positions.size(); ++j) {
      if (i == j || !is_indistinguishable(positions[i], positions[j], coincidence)) continue;
      found.push_back(static_cast<Index>(i));
      break;
    }
  }
  return found;
}

/// Both ways of counting, against all pairs.
void expect_agreement(const std::vector<Vec3>& positions) {
  for (const Coincidence coincidence : {Coincidence::Tolerant, Coincidence::Exact}) {
    EXPECT_EQ(find_indistinguishable_vertices(positions, coincidence),
              compare_all_pairs(positions, coincidence));
  }
}

/// Points whose coordinates are origin + step * (0, 1, ..., 11).
std::vector<Vec3> lattice_points(std::mt19937& random, std::size_t n, const Vec3& origin,
                                 const Vec3& step) {
  constexpr unsigned kSteps = 12;
  std::vector<Vec3> positions(n);
  for (Vec3& p : positions) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      p[k] = origin[k] + step[k] * static_cast<double>(random() % kSteps);
    }
  }
  return positions;
}

TEST(IsIndistinguishable, ZerosOfBothSignsAreEqual) {
  EXPECT_TRUE(is_indistinguishable({0.0, 0, 0}, {-0.0, 0, 0}, Coincidence::Exact));
}

TEST(IsIndistinguishable, ExactSeparatesNeighbouringNumbers) {
  const Vec3 a(1, 1, 1);
  const Vec3 b(1, 1, std::nextafter(1.0, 2.0));
  EXPECT_FALSE(is_indistinguishable(a, b, Coincidence::Exact));
  EXPECT_TRUE(is_indistinguishable(a, b, Coincidence::Tolerant));
}

TEST(IsIndistinguishable, ToleranceIsAbsoluteUpToOneAndRelativeBeyond) {
  // 2^-34 = 5.8e-11 and 2^-33 = 1.16e-10 lie on either side of 1e-10.
  const double below = std::ldexp(1.0, -34);
  const double above = std::ldexp(1.0, -33);
  for (const double scale : {1.0, 1024.0, std::ldexp(1.0, 900)}) {
    const Vec3 a(scale, 0, 0);
    EXPECT_TRUE(is_indistinguishable(a, {scale * (1 + below), 0, 0}, Coincidence::Tolerant));
    EXPECT_FALSE(is_indistinguishable(a, {scale * (1 + above), 0, 0}, Coincidence::Tolerant));
    EXPECT_TRUE(is_indistinguishable(a, {scale * (1 + below), below, 0}, Coincidence::Tolerant));
    EXPECT_FALSE(is_indistinguishable(a, {scale, 0, above}, Coincidence::Tolerant));
  }
  EXPECT_TRUE(is_indistinguishable({below / 2, 0, 0}, {-below / 2, 0, 0}, Coincidence::Tolerant));
}

TEST(FindIndistinguishableVertices, NoneOrOneVertexHasNoCompany) {
  EXPECT_TRUE(find_indistinguishable_vertices({}, Coincidence::Tolerant).empty());
  const std::vector<Vec3> one{{1, 2, 3}};
  EXPECT_TRUE(find_indistinguishable_vertices(one, Coincidence::Tolerant).empty());
  EXPECT_TRUE(find_indistinguishable_vertices(one, Coincidence::Exact).empty());
}

TEST(FindIndistinguishableVertices, AllMembersOfAPlaceAreNamedInOrder) {
  const std::vector<Vec3> positions{{1, 1, 1}, {5, 5, 5}, {1, 1, 1}, {1, 1, 2}, {1, 1, 1}};
  EXPECT_EQ(find_indistinguishable_vertices(positions, Coincidence::Exact),
            (std::vector<Index>{0, 2, 4}));
}

TEST(FindIndistinguishableVertices, NearPointsCountOnlyWithTolerance) {
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 5e-11}, {1, 0, 0}, {1, 0, 2e-10}};
  EXPECT_EQ(find_indistinguishable_vertices(positions, Coincidence::Tolerant),
            (std::vector<Index>{1, 2}));
  EXPECT_TRUE(find_indistinguishable_vertices(positions, Coincidence::Exact).empty());
}

TEST(FindIndistinguishableVertices, AgreesWithAllPairsOnRandomPoints) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-3, 3);
    std::vector<Vec3> positions(200);
    for (Vec3& p : positions) p = Vec3(uniform(random), uniform(random), uniform(random));
    for (std::size_t i = 0; i < 20; ++i) {
      positions.push_back(positions[random() % 200] +
                          4e-11 * Vec3(uniform(random), uniform(random), uniform(random)));
    }
    expect_agreement(positions);
  }
}

TEST(FindIndistinguishableVertices, AgreesWithAllPairsOnThousandsOfPoints) {
  // Spread evenly, nearly all in a thousandth of the range, and with the widest range there is.
  const double largest = std::numeric_limits<double>::max();
  for (const double far : {3.0, 3000.0, largest}) {
    SCOPED_TRACE(far);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-3, 3);
    std::vector<Vec3> positions{{-far, 0, 0}, {far, 0, 0}};
    while (positions.size() < 2000) {
      positions.emplace_back(uniform(random), uniform(random), uniform(random));
    }
    for (std::size_t i = 0; i < 100; ++i) {
      positions.push_back(positions[2 + random() % 1998] +
                          4e-11 * Vec3(uniform(random), uniform(random), uniform(random)));
    }
    expect_agreement(positions);
  }
}

TEST(FindIndistinguishableVertices, AgreesWithAllPairsOnLattices) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    expect_agreement(lattice_points(random, 600, {-2, 0, 7}, {1, 0.5, 3}));
    expect_agreement(lattice_points(random, 60, {0, 0, 0}, {0, 1, 1}));
  }
}

TEST(FindIndistinguishableVertices, AgreesWithAllPairsNearTheTolerance) {
  for (std::uint32_t seed = 0; seed < 30 / test::one_of(); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (const double size : {0.0, 1.0, 1e3, -7e200}) {
      SCOPED_TRACE(size);
      const double unit = 1e-10 * std::max(1.0, std::abs(size));
      for (const double step : {0.3, 0.5, 0.9, 1.0, 1.1, 1.7, 1.9}) {
        SCOPED_TRACE(step);
        const Vec3 steps = unit * Vec3(step, 1.05 * step, 0.95 * step);
        expect_agreement(lattice_points(random, 12, Vec3::Constant(size), steps));
        expect_agreement(lattice_points(random, 400, Vec3::Constant(size), steps));
      }
    }
  }
}

TEST(FindIndistinguishableVertices, ToleranceIsThatOfEachAxis) {
  // On the x axis the tolerance is 1e-5, on the y axis 1e-10, on the z axis 1e-8.
  const Vec3 origin(1e5, 0, -100);
  for (const double step : {0.5, 0.9, 1.1}) {
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
      SCOPED_TRACE(seed);
      std::mt19937 random(seed);
      expect_agreement(lattice_points(random, 400, origin, step * Vec3(1e-5, 1e-10, 1e-8)));
    }
  }
}

TEST(FindIndistinguishableVertices, AgreesWithAllPairsOnDensePoints) {
  // Nothing can be cut apart by one coordinate, but few points are at the same place.
  for (const double extent : {3e-9, 1e-8, 3e-8}) {
    for (std::uint32_t seed = 0; seed < 5; ++seed) {
      SCOPED_TRACE(seed);
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> uniform(0, extent);
      std::vector<Vec3> positions(1500);
      for (Vec3& p : positions) p = Vec3(uniform(random), uniform(random), uniform(random));
      expect_agreement(positions);
    }
  }
}

TEST(FindIndistinguishableVertices, ManyPointsAtOnePlaceAreAllFound) {
  const std::vector<Vec3> positions(300000, Vec3(1, 2, 3));
  EXPECT_EQ(find_indistinguishable_vertices(positions, Coincidence::Tolerant).size(), 300000U);
  EXPECT_EQ(find_indistinguishable_vertices(positions, Coincidence::Exact).size(), 300000U);
}

TEST(FindIndistinguishableVertices, PlanarGridHasNone) {
  // 400 columns and rows that share their coordinates; a comparison of all pairs would not end.
  std::vector<Vec3> positions;
  for (int x = 0; x < 400; ++x) {
    for (int y = 0; y < 400; ++y) positions.emplace_back(x, y, 0);
  }
  EXPECT_TRUE(find_indistinguishable_vertices(positions, Coincidence::Tolerant).empty());
  EXPECT_TRUE(find_indistinguishable_vertices(positions, Coincidence::Exact).empty());
}

}  // namespace
}  // namespace meshalyzer
