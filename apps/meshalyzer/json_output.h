#pragma once

#include "meshalyzer/io/file_replacement.h"
#include "meshalyzer/report/json/report.h"
#include "output.h"
#include "run.h"

#include <iosfwd>
#include <optional>
#include <string>

namespace meshalyzer {

/// Writes the JSON report to standard output or to a file, which is replaced when the report is
/// complete.
class JsonOutput : public Output {
 public:
  /// @throws IoError if the file cannot be written.
  JsonOutput(const Run& run, std::ostream& out);

  JsonOutput(const JsonOutput&) = delete;
  JsonOutput& operator=(const JsonOutput&) = delete;

  // The following functions throw IoError if the file cannot be written.

  void on_mesh(Index number, const Analysis& mesh) override;
  void on_unreadable(Index number, const std::string& why) override;
  void on_findings(const ObjectFindings& findings) override;
  void finish(const SetAnalysis* set) override;

 private:
  const Run& run_;
  std::optional<FileReplacement> file_;
  JsonReport report_;
};

}  // namespace meshalyzer
