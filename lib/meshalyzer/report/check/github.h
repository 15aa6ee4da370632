#pragma once

#include "meshalyzer/report/check/check_report.h"
#include "meshalyzer/report/json/report.h"

namespace meshalyzer {

/// Workflow commands of GitHub Actions, which become annotations of the files; the totals are a
/// notice.
class CheckGithub : public CheckReport {
 public:
  explicit CheckGithub(TextSink sink) : sink_(std::move(sink)) {}

  void add(const FileFindings& file) override;
  void finish(const CheckTotals& totals, std::chrono::duration<double> elapsed) override;

 private:
  TextSink sink_;
};

}  // namespace meshalyzer
