#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/table.h"

#include <cstddef>

namespace meshalyzer {

/// Tells how many components the text report shows; JSON has them all.
inline constexpr std::size_t kMaxComponentRows = 20;

/// Returns the first n components, a row each.
[[nodiscard]] TextTable components_table(const Analysis& analysis, std::size_t n);

/// Appends a table of the first components, a row each; nothing where there are fewer than two.
void append_components(TextLines& lines, const Analysis& analysis);

}  // namespace meshalyzer
