#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace meshalyzer {

/// Returns the shortest decimal text that reads back as the same double; no locale. 6 is "6", never
/// "6.0". Infinities and NaN are "inf", "-inf", "nan".
[[nodiscard]] std::string shortest(double value);

/// Appends shortest(value) to `text` without a temporary.
void append_shortest(std::string& text, double value);

/// Reads a whole token as a double, whatever the locale: the nearest double, "inf" and "nan"
/// included, also with a leading '+'. A magnitude too large for a double gives an infinity, one too
/// small 0.
/// @return nothing where the token is not one number from end to end.
[[nodiscard]] std::optional<double> parse_real(std::string_view token);

/// Reads a whole token as a decimal integer, also with a leading '+'.
/// @return nothing where the token is not one integer from end to end, or does not fit.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view token);

}  // namespace meshalyzer
