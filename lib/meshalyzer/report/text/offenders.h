#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/mesh_report.h"

namespace meshalyzer {

/// Appends the section OFFENDING ELEMENTS: each list that is not empty, headed by its name and
/// length.
///
/// The lists of -b ... -f stand in it where they were asked for, empty ones too, whatever the
/// style; with OffenderStyle::None the section is only theirs, and left out where none was asked
/// for. Where only the attributes were analysed it names what prevents those. CustomPoints needs
/// Analysis::positions; without them it is Ids.
void append_offenders(TextLines& lines, const Analysis& analysis, OffenderStyle style);

/// The ids round a break of the numbering, the offender in brackets: `1 2 [4] 5 6`.
[[nodiscard]] std::string numbering_text(const NumberingBreak& place);

}  // namespace meshalyzer
