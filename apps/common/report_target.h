#pragma once

#include <string>

namespace meshalyzer {

/// Where a report for programs goes: "-" is standard output, in place of the text.
struct ReportTarget {
  std::string file = "-";

  [[nodiscard]] bool is_stdout() const { return file == "-"; }
};

}  // namespace meshalyzer
