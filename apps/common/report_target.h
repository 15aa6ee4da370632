#pragma once

#include <optional>
#include <string>

namespace meshalyzer {

/// The destination of a report for programs; "-" is standard output, in place of the text.
struct ReportTarget {
  std::string file = "-";

  [[nodiscard]] bool is_stdout() const { return file == "-"; }
};

/// Tells whether there is a report that goes to standard output.
[[nodiscard]] inline bool is_stdout(const std::optional<ReportTarget>& target) {
  return target && target->is_stdout();
}

}  // namespace meshalyzer
