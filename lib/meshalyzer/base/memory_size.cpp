#include "meshalyzer/base/memory_size.h"

#include "meshalyzer/base/control_group.h"
#include "meshalyzer/base/numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <system_error>
#include <unistd.h>

namespace meshalyzer {
namespace {

/// Returns the factor that the unit after a number stands for, or nothing when it is no unit.
std::optional<std::uint64_t> unit_of(std::string_view text) {
  if (text.empty() || text == "B") {
    return 1;
  }
  const std::size_t letter = std::string_view("kKMGT").find(text.front());
  const std::string_view ending = text.substr(1);
  if (letter == std::string_view::npos || !(ending.empty() || ending == "B" || ending == "iB")) {
    return std::nullopt;
  }
  const auto power = static_cast<unsigned>(std::max<std::size_t>(letter, 1));
  return std::uint64_t{1} << (10 * power);
}

/// Returns the whole bytes in the decimal fraction 0.`digits` of a unit; `digits` may be empty.
std::uint64_t fraction_of(std::uint64_t unit, std::string_view digits) {
  const std::optional<double> fraction = parse_real("0." + std::string(digits) + "0");
  const double bytes = std::floor(fraction.value_or(0.0) * static_cast<double>(unit));
  // A fraction with so many nines that it reads as 1 is still below 1.
  return std::min(static_cast<std::uint64_t>(bytes), unit - 1);
}

}  // namespace

std::optional<std::uint64_t> parse_memory_size(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789";
  const auto digits_of = [&](std::string_view from) {
    return from.substr(0, from.find_first_not_of(kDigits));
  };
  const std::string_view whole_digits = digits_of(text);
  std::uint64_t whole = 0;
  const auto [end, error] =
      std::from_chars(whole_digits.data(), whole_digits.data() + whole_digits.size(), whole);
  if (error != std::errc{}) {
    return std::nullopt;
  }
  text.remove_prefix(whole_digits.size());
  std::string_view fraction_digits;
  if (text.starts_with('.')) {
    fraction_digits = digits_of(text.substr(1));
    if (fraction_digits.empty()) {
      return std::nullopt;
    }
    text.remove_prefix(1 + fraction_digits.size());
  }
  const std::optional<std::uint64_t> unit = unit_of(text);
  // Units are powers of two: where the whole units fit, one more fraction of a unit fits too.
  if (!unit || whole > std::numeric_limits<std::uint64_t>::max() / *unit) {
    return std::nullopt;
  }
  const std::uint64_t bytes = whole * *unit + fraction_of(*unit, fraction_digits);
  return bytes == 0 ? std::nullopt : std::optional(bytes);
}

std::uint64_t physical_memory() {
  const auto pages = static_cast<std::uint64_t>(std::max(0L, ::sysconf(_SC_PHYS_PAGES)));
  const auto page_bytes = static_cast<std::uint64_t>(std::max(0L, ::sysconf(_SC_PAGESIZE)));
  const std::uint64_t machine = pages * page_bytes;
  return std::min(machine, control_group_memory({}).value_or(machine));
}

}  // namespace meshalyzer
