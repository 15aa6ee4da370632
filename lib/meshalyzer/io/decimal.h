#pragma once

#include "meshalyzer/base/numbers.h"

#include <array>
#include <bit>
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

/// The powers of ten up to that of the most digits that fit in 64 bits; doubles hold them exactly.
inline constexpr double kExactPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,
                                               1e7,  1e8,  1e9,  1e10, 1e11, 1e12, 1e13,
                                               1e14, 1e15, 1e16, 1e17, 1e18, 1e19};
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

#ifdef __SIZEOF_INT128__
__extension__ using Uint128 = unsigned __int128;

/// The powers of five for as many digits.
inline constexpr auto kPowersOfFive = [] {
  std::array<std::uint64_t, 20> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 5 * powers[i - 1];
  return powers;
}();

/// Returns the double nearest to `mantissa` / 10^`fractional`, by one division of whole numbers.
///
/// If mantissa and 5^fractional are shifted until their highest bits are set, their quotient has 63
/// or 64 bits. Its lowest bit is set if there is a remainder; that is far below the 53 bits of a
/// double and the bit that decides how they are rounded, so that the conversion rounds rightly.
///
/// @pre mantissa > 0 and fractional < 20
inline double divide_by_power_of_ten(std::uint64_t mantissa, std::ptrdiff_t fractional) {
  const std::uint64_t five = kPowersOfFive[static_cast<std::size_t>(fractional)];
  const int shift = std::countl_zero(mantissa);
  const int shift_of_five = std::countl_zero(five);
  const std::uint64_t divisor = five << shift_of_five;
  const Uint128 dividend = Uint128{mantissa << shift} << 63U;
  const auto quotient = static_cast<std::uint64_t>(dividend / divisor);
  // The remainder is less than the divisor, so that its lowest 64 bits are all of it.
  const std::uint64_t remainder = static_cast<std::uint64_t>(dividend) - quotient * divisor;
  // Half of the quotient is converted, because a signed number takes one instruction.
  const std::uint64_t half = quotient >> 1U | (quotient & 1U) | (remainder != 0 ? 1U : 0U);
  const int exponent = shift_of_five - shift - 62 - static_cast<int>(fractional);
  const auto power_of_two =
      std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52U);
  return static_cast<double>(static_cast<std::int64_t>(half)) * power_of_two;
}
#endif

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
/// If the digits make an integer m <= 2^53, m and 10^k are doubles for k digits behind the point,
/// so that one division rounds once and is right (Clinger 1990, "How to read floating point numbers
/// accurately"). Larger integers of up to 19 digits are divided as such. What has more digits or an
/// exponent is left to std::from_chars.
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
  if (digits == 0 || digits > kDigitsThatFit || has_exponent) {
    return scan_any_real(begin, end);
  }
  const auto with_sign = [&](double value) {
    return Decimal<double>{negative ? -value : value, at};
  };
  if (mantissa <= kLargestExactInteger) {
    return with_sign(static_cast<double>(mantissa) / kExactPowersOfTen[fractional]);
  }
#ifdef __SIZEOF_INT128__
  return with_sign(divide_by_power_of_ten(mantissa, fractional));
#else
  return scan_any_real(begin, end);
#endif
}

}  // namespace meshalyzer
