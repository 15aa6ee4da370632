#pragma once

#include "meshalyzer/report/check/check_report.h"
#include "meshalyzer/report/json/report.h"

#include <string>

namespace meshalyzer {

/// One finding a line, as compilers tell theirs, and a last line of totals.
class CheckText : public CheckReport {
 public:
  CheckText(TextSink sink, TextColour colour) : sink_(std::move(sink)), colour_(colour) {}

  void add(const FileFindings& file) override;
  void finish(const CheckTotals& totals, std::chrono::duration<double> elapsed) override;

 private:
  [[nodiscard]] std::string coloured(Severity severity, std::string_view text) const;

  TextSink sink_;
  TextColour colour_;
};

}  // namespace meshalyzer
