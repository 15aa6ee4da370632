#include "meshalyzer/exact/balanced_matrix.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace meshalyzer {
namespace {

/// Keeps the largest exponent of numbers that are not zero.
void take_largest(std::optional<int>& largest, const WideNumber& number, int less) {
  if (number.mantissa == 0.0) return;
  const int exponent = number.exponent - less;
  largest = largest ? std::max(*largest, exponent) : exponent;
}

}  // namespace

WideNumber wide(double x) {
  WideNumber number;
  number.mantissa = std::frexp(x, &number.exponent);
  return number;
}

WideNumber wide_difference(double a, double b) {
  const double difference = a - b;
  if (std::isfinite(difference)) return wide(difference);
  // Both are so large that halving them is exact.
  WideNumber half = wide(0.5 * a - 0.5 * b);
  ++half.exponent;
  return half;
}

template <std::size_t N>
BalancedMatrix<N> balance(const WideMatrix<N>& matrix) {
  BalancedMatrix<N> result;
  for (std::size_t i = 0; i < N; ++i) {
    std::optional<int> largest;
    for (const WideNumber& number : matrix[i]) take_largest(largest, number, 0);
    result.row[i] = largest.value_or(0);
  }
  for (std::size_t j = 0; j < N; ++j) {
    std::optional<int> largest;
    for (std::size_t i = 0; i < N; ++i) take_largest(largest, matrix[i][j], result.row[i]);
    result.column[j] = largest.value_or(0);
  }
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) {
      const auto& [mantissa, exponent] = matrix[i][j];
      result.entries[i][j] = std::ldexp(mantissa, exponent - result.row[i] - result.column[j]);
    }
  }
  return result;
}

template BalancedMatrix<2> balance(const WideMatrix<2>& matrix);
template BalancedMatrix<3> balance(const WideMatrix<3>& matrix);

}  // namespace meshalyzer
