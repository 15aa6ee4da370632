#include "meshalyzer/base/numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <system_error>

namespace meshalyzer {
namespace {

/// Stands for any exponent beyond the length of a text.
constexpr std::int64_t kHugeExponent = std::int64_t{1} << 60;

/// Strips a leading '+', which std::from_chars rejects; strtod and every mesh format accept it.
std::string_view without_plus(std::string_view token) {
  if (token.size() > 1 && token.front() == '+' && token[1] != '-' && token[1] != '+') {
    token.remove_prefix(1);
  }
  return token;
}

/// Returns the value of a well-formed number that std::from_chars reports as out of range: an
/// infinity or a zero, depending on where its first non-zero digit stands.
double out_of_range(std::string_view token) {
  const bool negative = token.front() == '-';
  const std::size_t exponent_at = std::min(token.find_first_of("eE"), token.size());
  const std::string_view digits = token.substr(0, exponent_at);
  const auto point = static_cast<std::int64_t>(std::min(digits.find('.'), digits.size()));
  const auto first = static_cast<std::int64_t>(digits.find_first_of("123456789"));
  std::int64_t exponent = 0;
  if (exponent_at != token.size()) {
    const std::string_view text = without_plus(token.substr(exponent_at + 1));
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
    if (error == std::errc::result_out_of_range) {
      exponent = text.front() == '-' ? -kHugeExponent : kHugeExponent;
    }
  }
  const double magnitude =
      point - first + exponent > 0 ? std::numeric_limits<double>::infinity() : 0.0;
  return negative ? -magnitude : magnitude;
}

}  // namespace

std::string shortest(double value) {
  std::string text;
  append_shortest(text, value);
  return text;
}

void append_shortest(std::string& text, double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  text.append(buffer, end);
}

std::string readable(double value) {
  char buffer[32];
  const double number = value + 0.0;  // -0.0 + 0.0 is 0.0
  const auto [end, error] =
      std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::general, 10);
  return {buffer, end};
}

std::optional<double> parse_real(std::string_view token) {
  token = without_plus(token);
  double value = 0.0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size() || error == std::errc::invalid_argument) {
    return std::nullopt;
  }
  return error == std::errc::result_out_of_range ? out_of_range(token) : value;
}

std::optional<std::int64_t> parse_integer(std::string_view token) {
  token = without_plus(token);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size() || error != std::errc{}) {
    return std::nullopt;
  }
  return value;
}

}  // namespace meshalyzer
