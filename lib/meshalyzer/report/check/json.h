#pragma once

#include "meshalyzer/report/check/check_report.h"
#include "meshalyzer/report/json/report.h"
#include "meshalyzer/report/json/writer.h"

#include <string>

namespace meshalyzer {

/// One JSON object: all files, each with its findings, and the totals (doc/check.schema.json).
class CheckJson : public CheckReport {
 public:
  explicit CheckJson(TextSink sink);

  void add(const FileFindings& file) override;
  void finish(const CheckTotals& totals, std::chrono::duration<double> elapsed) override;

 private:
  TextSink sink_;
  JsonWriter json_;
};

/// A line of JSON for each file, the same object as in CheckJson, as soon as it is done; the last
/// line holds the totals.
class CheckNdjson : public CheckReport {
 public:
  explicit CheckNdjson(TextSink sink) : sink_(std::move(sink)) {}

  void add(const FileFindings& file) override;
  void finish(const CheckTotals& totals, std::chrono::duration<double> elapsed) override;

 private:
  TextSink sink_;
};

/// The JSON Schema of CheckJson: doc/check.schema.json. The lines of CheckNdjson are its "mesh".
[[nodiscard]] std::string check_json_schema();

}  // namespace meshalyzer
