#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/mesh_report.h"

namespace meshalyzer {

/// Returns the number of elements and, if a list is incomplete, the number of its entries.
///
/// @param is_at_least  Tells whether `n` is only a lower bound.
[[nodiscard]] std::string list_head(std::size_t n, std::size_t n_listed, bool is_at_least);

/// Appends the section OFFENDING ELEMENTS: each list that is not empty, headed by its name and
/// length.
///
/// Lists requested by a threshold are always present, even empty ones, in any style; with
/// OffenderStyle::None the section has only those, and is omitted if none was requested. If only
/// the attributes were analysed, it names the elements that decide them. CustomPoints needs
/// Analysis::soup; without it the style is Ids.
void append_offenders(TextLines& lines, const Analysis& analysis, OffenderStyle style);

/// Returns the ids round a break of the numbering, the offender in brackets: `1 2 [4] 5 6`.
[[nodiscard]] std::string numbering_text(const NumberingBreak& place);

}  // namespace meshalyzer
