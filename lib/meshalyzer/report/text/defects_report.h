#pragma once

#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/report/repair_report.h"

#include <string>

namespace meshalyzer {

/// Tells how long the lists of elements in a text may be.
enum class ListLength {
  /// The first few, and how many there are beyond.
  Short,
  Full,
};

/// Returns the report of what is wrong with a mesh, for people: what was looked for, the count of
/// each code, a line a defect, and what a repair would make of the self-intersections.
[[nodiscard]] std::string text_report(const FoundDefects& found, ListLength lists);

}  // namespace meshalyzer
