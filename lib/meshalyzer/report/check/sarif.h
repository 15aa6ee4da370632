#pragma once

#include "meshalyzer/report/check/check_report.h"
#include "meshalyzer/report/json/report.h"
#include "meshalyzer/report/json/writer.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// A log in SARIF 2.1.0 (OASIS), which code hosts show beside the files. The rules are the defect
/// codes, the limits, and one of files that cannot be read.
class CheckSarif : public CheckReport {
 public:
  explicit CheckSarif(TextSink sink);

  void add(const FileFindings& file) override;
  void finish(const CheckTotals& totals, std::chrono::duration<double> elapsed) override;

 private:
  void write_notes();

  TextSink sink_;
  JsonWriter json_;
  /// Addresses of all files, for "artifacts".
  std::vector<std::string> addresses_;
  struct Note {
    std::string address;
    std::string text;
  };
  /// What is said of files that is no finding, for "toolExecutionNotifications".
  std::vector<Note> notes_;
};

}  // namespace meshalyzer
