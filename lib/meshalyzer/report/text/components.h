#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/table.h"

#include <cstddef>

namespace meshalyzer {

/// The number of components that the text report shows; JSON has them all.
inline constexpr std::size_t kMaxComponentRows = 20;

/// Returns a table of the first n components, one row for each.
[[nodiscard]] TextTable components_table(const Analysis& analysis, std::size_t n);

/// Appends a table of the first components, one row for each; nothing if there are fewer than two.
void append_components(TextLines& lines, const Analysis& analysis);

}  // namespace meshalyzer
