#pragma once

#include <array>
#include <cstddef>

namespace meshalyzer {

/// A number beyond the range of doubles: mantissa * 2^exponent, with a mantissa of magnitude 1/2 to
/// 1, or zero.
struct WideNumber {
  double mantissa = 0.0;
  int exponent = 0;
};

/// Returns a double as a wide number.
[[nodiscard]] WideNumber wide(double x);

/// Returns a - b with a relative error of at most 2^-53, where the difference of the doubles may
/// overflow.
[[nodiscard]] WideNumber wide_difference(double a, double b);

/// Rows and columns of wide numbers.
template <std::size_t N>
using WideMatrix = std::array<std::array<WideNumber, N>, N>;

/// A matrix in doubles, of which the determinant has the sign of that of a matrix of wide numbers.
template <std::size_t N>
struct BalancedMatrix {
  /// The entries, each row and each column multiplied by a power of two, so that none exceeds 1 in
  /// magnitude and the largest of each column is at least 1/2. Small ones may underflow, with an
  /// absolute error below the smallest double.
  std::array<std::array<double, N>, N> entries{};
  /// The powers: entry (i, j) was multiplied by 2^-(row[i] + column[j]).
  std::array<int, N> row{};
  std::array<int, N> column{};
};

/// Covers what a determinant of a balanced matrix loses where small entries, or products of them,
/// underflow.
inline constexpr double kLostInBalance = 0x1p-1060;

/// Balances a matrix of two or three rows. A row or a column of zeros stays as it is.
template <std::size_t N>
[[nodiscard]] BalancedMatrix<N> balance(const WideMatrix<N>& matrix);

}  // namespace meshalyzer
