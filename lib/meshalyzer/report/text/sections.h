#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/text/lines.h"

namespace meshalyzer {

/// Appends the name of the file and the integrity of its records.
void append_integrity(LineSink& lines, const Analysis& analysis);

/// Appends the five attributes, or the reason if there is no answer.
void append_attributes(LineSink& lines, const Attributes& attributes);

/// Appends the counts among the characteristics.
void append_counts(LineSink& lines, const Characteristics& c);

/// Appends bounding box, area, volume and genus.
void append_extent(LineSink& lines, const Characteristics& c);

}  // namespace meshalyzer
