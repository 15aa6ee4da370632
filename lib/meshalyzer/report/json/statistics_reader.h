#pragma once

#include "meshalyzer/base/statistics.h"
#include "meshalyzer/report/json/tree.h"

namespace meshalyzer {

/// What write_statistics() wrote.
[[nodiscard]] Statistics read_statistics(const JsonNode& object);

/// What write_summary() wrote.
[[nodiscard]] Summary read_summary(const JsonNode& object);

/// A real that is a member of `object`, found in what write_non_finite() wrote where it is null.
/// @return nothing where it is null and not there either.
[[nodiscard]] std::optional<double> find_real(const JsonNode& object, std::string_view name);

/// The same, where there must be a value.
[[nodiscard]] double read_real(const JsonNode& object, std::string_view name);

}  // namespace meshalyzer
