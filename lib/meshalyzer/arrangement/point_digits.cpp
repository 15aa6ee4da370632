#include "meshalyzer/arrangement/point_digits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace meshalyzer {
namespace {

/// A number with fewer binary digits is no block of the heap: CGAL::Mpzf holds eight words of 64.
constexpr std::size_t kDigitsOffHeap = 512;

/// The exponents of the first and the last binary digit of some numbers.
struct DigitRange {
  int first = std::numeric_limits<int>::min();
  int last = std::numeric_limits<int>::max();

  void include(double x) {
    if (x == 0.0) return;
    const int exponent = std::ilogb(x);
    first = std::max(first, exponent);
    last = std::min(last, exponent - (std::numeric_limits<double>::digits - 1));
  }

  void include(const DigitRange& range) {
    first = std::max(first, range.first);
    last = std::min(last, range.last);
  }

  /// Returns the number of digits of the difference of any two of the numbers.
  [[nodiscard]] std::size_t size() const {
    return first < last ? 0 : static_cast<std::size_t>(first - last) + 2;
  }
};

/// The degrees of the numerators and of the denominator of a point.
struct Degrees {
  std::size_t numerator, denominator;
};

Degrees degrees_of(PointKind kind) {
  switch (kind) {
    case PointKind::LineAndPlane:
      return {4, 3};
    case PointKind::TwoLines:
      return {3, 2};
    case PointKind::ThreePlanes:
      return {7, 6};
    case PointKind::Vertex:
      break;
  }
  return {1, 0};
}

std::size_t heap_bytes(std::size_t n_digits) {
  return n_digits <= kDigitsOffHeap ? 0 : n_digits / 8;
}

DigitRange range_of(const Soup& soup, std::span<const DigitRange> of_vertices,
                    const PointName& name) {
  DigitRange range;
  const auto include_vertices = [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) range.include(of_vertices[name.of[k]]);
  };
  const auto include_faces = [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      for (const Index v : soup.triangles[name.of[k]]) range.include(of_vertices[v]);
    }
  };
  switch (name.kind) {
    case PointKind::Vertex:
      include_vertices(0, 1);
      break;
    case PointKind::LineAndPlane:
      include_vertices(0, 2);
      include_faces(2, 3);
      break;
    case PointKind::TwoLines:
      include_vertices(0, 4);
      break;
    case PointKind::ThreePlanes:
      include_faces(0, 3);
      break;
  }
  return range;
}

}  // namespace

std::size_t most_digit_bytes(const Soup& soup, std::span<const PointName> names) {
  std::vector<DigitRange> of_vertices(soup.n_vertices());
  for (std::size_t v = 0; v < of_vertices.size(); ++v) {
    for (const double x : soup.positions[v]) of_vertices[v].include(x);
  }
  std::size_t n_bytes = 0;
  for (const PointName& name : names) {
    const std::size_t n_digits = range_of(soup, of_vertices, name).size();
    const Degrees degrees = degrees_of(name.kind);
    n_bytes +=
        3 * heap_bytes(degrees.numerator * n_digits) + heap_bytes(degrees.denominator * n_digits);
  }
  return n_bytes;
}

}  // namespace meshalyzer
