#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/mesh_report.h"

namespace meshalyzer {

/// Says how many elements there are, and where a list leaves some out, how many it holds.
[[nodiscard]] std::string list_head(std::size_t n, std::size_t n_listed);

/// Appends the section OFFENDING ELEMENTS: each list that is not empty, headed by its name and
/// length.
///
/// Lists that were asked for by a threshold are always there, empty ones too, whatever the style;
/// with OffenderStyle::None the section holds only those, and is left out where none was asked for.
/// Where only the attributes were analysed it names what prevents those. CustomPoints needs
/// Analysis::soup; without it it is Ids.
void append_offenders(TextLines& lines, const Analysis& analysis, OffenderStyle style);

/// Returns the ids round a break of the numbering, the offender in brackets: `1 2 [4] 5 6`.
[[nodiscard]] std::string numbering_text(const NumberingBreak& place);

}  // namespace meshalyzer
