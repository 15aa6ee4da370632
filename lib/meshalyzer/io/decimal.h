#pragma once

#include "meshalyzer/base/numbers.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <system_error>

namespace meshalyzer {

/// A number at the beginning of a text and its end; `end` is null if there is none of the expected
/// form.
template <typename T>
struct Decimal {
  T value{};
  const char* end = nullptr;
};

namespace decimal_internal {

/// The powers of ten that are exact as doubles.
inline constexpr double kExactPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                               1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                               1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
inline constexpr int kLargestExactPower = 22;
/// Integers up to here are exact as doubles.
inline constexpr std::uint64_t kLargestExactInteger = std::uint64_t{1} << 53;

constexpr bool is_digit(char c) {
  return static_cast<unsigned char>(c - '0') < 10;
}

/// Reads any finite number; one that underflows is 0.
inline Decimal<double> scan_any_real(const char* begin, const char* end) {
  double value = 0.0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error == std::errc::result_out_of_range) {
    value = parse_real({begin, static_cast<std::size_t>(stop - begin)}).value_or(0.0);
  } else if (error != std::errc{}) {
    return {};
  }
  return std::isfinite(value) ? Decimal<double>{value, stop} : Decimal<double>{};
}

}  // namespace decimal_internal

/// Reads the non-negative integer of at most 18 digits at the beginning of [begin, end).
[[nodiscard]] inline Decimal<std::int64_t> scan_digits(const char* begin, const char* end) {
  constexpr std::ptrdiff_t kDigitsThatFit = 18;
  std::int64_t value = 0;
  const char* at = begin;
  while (at != end && decimal_internal::is_digit(*at)) {
    if (at - begin == kDigitsThatFit) {
      return {};
    }
    value = value * 10 + (*at++ - '0');
  }
  return {value, at == begin ? nullptr : at};
}

/// Reads the finite number at the beginning of [begin, end): the nearest double.
///
/// If the digits make an integer m <= 2^53 and the exponent k is within 22, m and 10^|k| are
/// doubles, so that one multiplication or division rounds once and is right (Clinger 1990, "How to
/// read floating point numbers accurately"). Everything else is left to std::from_chars.
[[nodiscard]] inline Decimal<double> scan_real(const char* begin, const char* end) {
  using namespace decimal_internal;
  constexpr std::ptrdiff_t kDigitsThatFit = 19;
  const char* at = begin;
  const bool negative = at != end && *at == '-';
  at += negative ? 1 : 0;
  const char* const integral = at;
  std::uint64_t mantissa = 0;
  for (; at != end && is_digit(*at); ++at) {
    mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
  }
  std::ptrdiff_t digits = at - integral;
  std::ptrdiff_t fractional = 0;
  if (at != end && *at == '.') {
    const char* const fraction = ++at;
    for (; at != end && is_digit(*at); ++at) {
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
    }
    fractional = at - fraction;
    digits += fractional;
  }
  const bool has_exponent = at != end && (*at == 'e' || *at == 'E');
  if (digits == 0 || digits > kDigitsThatFit || mantissa > kLargestExactInteger ||
      fractional > kLargestExactPower || has_exponent) {
    return scan_any_real(begin, end);
  }
  const double value = static_cast<double>(mantissa) / kExactPowersOfTen[fractional];
  return {negative ? -value : value, at};
}

}  // namespace meshalyzer
