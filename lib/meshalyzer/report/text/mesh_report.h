#pragma once

#include "meshalyzer/analysis/analysis.h"

#include <string>

namespace meshalyzer {

/// Tells how offending elements are named in the text report.
enum class OffenderStyle {
  /// Offenders are counted, not named.
  None,
  /// Offenders are named by their file ids.
  Ids,
  /// Like Ids, but vertices are written as DReAMM custom points, `x y z 1 0 0 1` a line.
  CustomPoints,
};

/// Returns the report of one mesh for people: three sections, one `name: value` a line.
[[nodiscard]] std::string text_report(const Analysis& analysis, OffenderStyle offenders);

}  // namespace meshalyzer
