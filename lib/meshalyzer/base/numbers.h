#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace meshalyzer {

/// Returns the shortest decimal text that reads back as the same double, independent of the locale.
/// 6 is "6", never "6.0". Infinities and NaN are "inf", "-inf", "nan".
[[nodiscard]] std::string shortest(double value);

/// Appends shortest(value) to `text` without a temporary.
void append_shortest(std::string& text, double value);

/// Returns a real for people: ten significant digits at most, independent of the locale, no "-0".
[[nodiscard]] std::string readable(double value);

/// Parses a whole token as a double, independent of the locale. "inf", "nan" and a leading '+' are
/// accepted. The result is the nearest double, an infinity for a magnitude that is too large, 0 for
/// one that is too small.
/// @return Nothing when the token is not exactly one number.
[[nodiscard]] std::optional<double> parse_real(std::string_view token);

/// Parses a whole token as a decimal integer; a leading '+' is accepted.
/// @return Nothing when the token is not exactly one integer, or does not fit.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view token);

}  // namespace meshalyzer
