#pragma once

#include "meshalyzer/io/file_replacement.h"
#include "meshalyzer/report/json/report.h"
#include "options.h"

#include <iosfwd>
#include <memory>
#include <optional>

namespace meshalyzer {

/// The JSON report on its way to standard output or a file, which it replaces when it is complete.
class JsonOutput {
 public:
  /// @throws IoError if the file cannot be written.
  JsonOutput(const ReportTarget& target, JsonOffenders offenders, std::ostream& out);

  JsonOutput(const JsonOutput&) = delete;
  JsonOutput& operator=(const JsonOutput&) = delete;

  [[nodiscard]] JsonReport& report() { return report_; }
  /// Ends the report.
  ///
  /// @param set  Null where there is none to tell of.
  /// @throws IoError if the file cannot be written.
  void finish(const SetAnalysis* set);

 private:
  std::optional<FileReplacement> file_;
  JsonReport report_;
};

}  // namespace meshalyzer
