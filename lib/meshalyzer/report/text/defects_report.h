#pragma once

#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/report/repair_report.h"

#include <string>

namespace meshalyzer {

/// The length of lists in a text.
enum class ListLength {
  /// The first few, and the number of the others.
  Short,
  Full,
};

/// Returns the report of the defects of a mesh for people: the codes searched, the count of each
/// code, a line for each defect, and the outcome of a repair for the self-intersections.
[[nodiscard]] std::string text_report(const FoundDefects& found, ListLength lists);

}  // namespace meshalyzer
