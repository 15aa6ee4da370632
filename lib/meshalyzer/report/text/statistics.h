#pragma once

#include "meshalyzer/analysis/element_measures.h"
#include "meshalyzer/base/statistics.h"
#include "meshalyzer/report/text/lines.h"

#include <array>
#include <string>

namespace meshalyzer {

/// Returns the edges of the bins with as few digits as distinguish neighbours, at least four.
[[nodiscard]] std::array<std::string, Histogram::kBins + 1> edge_texts(const Histogram& histogram);

/// Appends the figures of a quantity, one per line, and its histogram as rows of two bins.
///
/// A histogram needs two different values; its bins are printed with as few digits as distinguish
/// them.
void append_statistics(TextLines& lines, const Quantity& quantity, const Statistics& statistics);

/// Appends the statistics of vertices, edges and faces.
void append_measures(TextLines& lines, const ElementMeasures<Statistics>& measures);

}  // namespace meshalyzer
