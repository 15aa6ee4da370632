#include "meshalyzer/arrangement/point_digits.h"

#include "support/random_soups.h"

#include <gtest/gtest.h>

#include <CGAL/Gmpq.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

constexpr unsigned kSeedOfPoints = 4;

/// Returns the bytes of a number of more than 512 binary digits, without zeros at its end.
std::size_t heap_bytes_of(const CGAL::Mpzf& number) {
  const CGAL::Gmpq exact(number);
  if (exact == 0) return 0;
  const CGAL::Gmpz numerator = exact.numerator();
  const std::size_t n_digits = mpz_sizeinbase(numerator.mpz(), 2) - mpz_scan1(numerator.mpz(), 0);
  return n_digits <= 512 ? 0 : n_digits / 8;
}

std::size_t heap_bytes_of(const ExactPoint& point) {
  std::size_t n_bytes = heap_bytes_of(point.denominator);
  for (const CGAL::Mpzf& number : point.numerator) n_bytes += heap_bytes_of(number);
  return n_bytes;
}

/// Returns three faces, each with three vertices of its own, whose coordinates have exponents up to
/// a maximum.
Soup faces_of_exponents(int max_exponent, std::mt19937& random) {
  Soup soup;
  std::uniform_int_distribution<int> exponent(-max_exponent, max_exponent);
  const auto coordinate = [&] { return std::ldexp(uniform(random, -1.0, 1.0), exponent(random)); };
  for (Index v = 0; v < 9; ++v) {
    soup.positions.emplace_back(coordinate(), coordinate(), coordinate());
  }
  soup.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  return soup;
}

TEST(MostDigitBytes, PointsHaveNoMore) {
  std::mt19937 random(kSeedOfPoints);
  std::size_t n_with_digits = 0;
  for (int round = 0; round < 200; ++round) {
    const Soup soup = faces_of_exponents(round, random);
    for (const PointName& name :
         {vertex_name(0), line_and_plane_name({0, 1}, 1), two_lines_name({0, 1}, {3, 4}, Axis::X),
          three_planes_name({0, 1, 2})}) {
      const std::size_t n_bytes = heap_bytes_of(construct_point(soup, name));
      EXPECT_LE(n_bytes, most_digit_bytes(soup, std::vector{name})) << round;
      n_with_digits += n_bytes > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(n_with_digits, 250U);
}

TEST(MostDigitBytes, EachVertexOfAPointCounts) {
  std::mt19937 random(kSeedOfPoints);
  const Soup soup = faces_of_exponents(0, random);
  const std::vector<std::pair<PointName, std::vector<Index>>> points{
      {line_and_plane_name({0, 1}, 1), {0, 1, 3, 4, 5}},
      {two_lines_name({0, 1}, {3, 4}, Axis::X), {0, 1, 3, 4}},
      {three_planes_name({0, 1, 2}), {0, 1, 2, 3, 4, 5, 6, 7, 8}}};
  for (const auto& [name, vertices] : points) {
    for (Index v = 0; v < soup.n_vertices(); ++v) {
      Soup far = soup;
      far.positions[v][v % 3] = 1e300;
      const bool counts = std::find(vertices.begin(), vertices.end(), v) != vertices.end();
      EXPECT_EQ(most_digit_bytes(far, std::vector{name}) > 0, counts) << v;
    }
  }
}

TEST(MostDigitBytes, OfOneScaleAreNone) {
  std::mt19937 random(kSeedOfPoints);
  const Soup soup = faces_of_exponents(0, random);
  EXPECT_EQ(most_digit_bytes(soup, std::vector{vertex_name(8), three_planes_name({0, 1, 2})}), 0U);
}

}  // namespace
}  // namespace meshalyzer
