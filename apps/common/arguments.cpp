#include "arguments.h"

#include "meshalyzer/base/numbers.h"

#include <cmath>
#include <cstdint>
#include <optional>

namespace meshalyzer {
namespace {

constexpr std::size_t kMaxThreads = 1024;

}  // namespace

void refuse_value(const std::string& option, const std::string& wanted, const std::string& text) {
  throw UsageError(option + " needs " + wanted + ", not '" + text + "'");
}

std::string_view without_sign(std::string_view text) {
  text.remove_prefix(text.starts_with('=') ? 1 : 0);
  return text;
}

double to_real(const std::string& text, const std::string& option) {
  const std::optional<double> value = parse_real(without_sign(text));
  if (!value || std::isnan(*value)) {
    refuse_value(option, "a number", text);
  }
  return *value;
}

double to_length(const std::string& text, const std::string& option) {
  const double value = to_real(text, option);
  if (!(value >= 0.0 && std::isfinite(value))) {
    refuse_value(option, "a finite length, 0 or more", text);
  }
  return value;
}

std::size_t to_count(const std::string& text, const std::string& option) {
  const std::optional<std::int64_t> count = parse_integer(text);
  if (!count || *count < 0) {
    refuse_value(option, "a whole number, 0 or more", text);
  }
  return static_cast<std::size_t>(*count);
}

double to_seconds(const std::string& text, const std::string& option) {
  const double seconds = to_real(text, option);
  if (!(seconds >= 0.0)) {
    refuse_value(option, "a number of seconds, 0 or more", text);
  }
  return seconds;
}

std::size_t to_count_from_one(const std::string& text, const std::string& option) {
  const std::optional<std::int64_t> count = parse_integer(text);
  if (!count || *count < 1) {
    refuse_value(option, "a whole number from 1", text);
  }
  return static_cast<std::size_t>(*count);
}

std::size_t to_thread_count(const std::string& text, const std::string& option) {
  const std::optional<std::int64_t> value = parse_integer(text);
  if (!value || *value < 0 || *value > static_cast<std::int64_t>(kMaxThreads)) {
    refuse_value(option, "a whole number from 0 to " + std::to_string(kMaxThreads), text);
  }
  return static_cast<std::size_t>(*value);
}

}  // namespace meshalyzer
