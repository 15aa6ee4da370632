#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/text/lines.h"

namespace meshalyzer {

/// Appends what the file is called and whether it says what it means.
void append_integrity(LineSink& lines, const Analysis& analysis);

/// Appends the five attributes; where there is no answer the reason.
void append_attributes(LineSink& lines, const Attributes& attributes);

/// Appends the counts among the characteristics.
void append_counts(LineSink& lines, const Characteristics& c);

/// Appends bounding box, area, volume and genus.
void append_extent(LineSink& lines, const Characteristics& c);

}  // namespace meshalyzer
