#pragma once

#include "meshalyzer/base/statistics.h"
#include "meshalyzer/report/text_lines.h"

namespace meshalyzer {

/// What a quantity is called in a report, and what there is to say of it.
struct QuantityName {
  std::string_view name;
  /// Why there may be no value of it, in words that follow "undefined: ".
  std::string_view if_none;
  enum class Total { Omit, Show };
  /// Whether the sum of all values means something.
  Total total = Total::Omit;
};

/// Appends the figures of a quantity, one a line, and its histogram as rows of two bins.
///
/// A histogram needs two different values; its bins are printed with as few digits as tell them
/// apart.
void append_statistics(TextLines& lines, const QuantityName& quantity,
                       const Statistics& statistics);

}  // namespace meshalyzer
