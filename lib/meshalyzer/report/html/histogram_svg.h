#pragma once

#include "meshalyzer/base/statistics.h"
#include "meshalyzer/report/html/writer.h"

#include <string_view>

namespace meshalyzer {

/// Appends a histogram as a drawing: a bar for each bin that is not empty, as high as its count is
/// large, lines at round counts, the values below. It fills the available space, and takes its
/// colours from the page.
/// @param name  The name of the quantity, for readers who cannot see the drawing.
void append_histogram_svg(HtmlWriter& html, std::string_view name, const Histogram& histogram);

}  // namespace meshalyzer
