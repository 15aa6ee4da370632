#pragma once

#include "meshalyzer/report/check/check_report.h"
#include "meshalyzer/report/json/report.h"

#include <string>

namespace meshalyzer {

/// A test suite in the XML of JUnit, which CI systems read: a case a file, which fails where the
/// mesh is not good, and is in error where it cannot be read. The head counts all cases, so the
/// report is written when all are known.
class CheckJunit : public CheckReport {
 public:
  explicit CheckJunit(TextSink sink) : sink_(std::move(sink)) {}

  void add(const FileFindings& file) override;
  void finish(const CheckTotals& totals, std::chrono::duration<double> elapsed) override;

 private:
  TextSink sink_;
  std::string cases_;
};

}  // namespace meshalyzer
