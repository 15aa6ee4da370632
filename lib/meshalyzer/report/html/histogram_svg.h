#pragma once

#include "meshalyzer/base/statistics.h"
#include "meshalyzer/report/html/writer.h"

#include <string_view>

namespace meshalyzer {

/// Appends a histogram as a drawing: a bar for each bin that is not empty, as high as its count is
/// large, lines at round counts, the values below. It has no size of its own but fills its place,
/// and takes its colours from the page.
/// @param name  Of the quantity, for those who do not see the drawing.
void append_histogram_svg(HtmlWriter& html, std::string_view name, const Histogram& histogram);

}  // namespace meshalyzer
