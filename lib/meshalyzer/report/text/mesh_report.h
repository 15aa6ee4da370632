#pragma once

#include "meshalyzer/analysis/analysis.h"

#include <string>

namespace meshalyzer {

/// The style in which the text report names offending elements.
enum class OffenderStyle {
  /// Offenders are counted, not named.
  None,
  /// Offenders are named by their file ids.
  Ids,
  /// Like Ids, but vertices are written as DReAMM custom points, one line `x y z 1 0 0 1` for each.
  CustomPoints,
};

/// Returns the report of one mesh for people: three sections, one `name: value` per line.
[[nodiscard]] std::string text_report(const Analysis& analysis, OffenderStyle offenders);

}  // namespace meshalyzer
