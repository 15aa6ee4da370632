#pragma once

#include "meshalyzer/report/check/check_report.h"
#include "meshalyzer/report/json/report.h"

#include <memory>
#include <string>

namespace meshalyzer {

// The formats of make_check_report().

/// Returns a report with one line for each finding, like messages of compilers, and a last line of
/// totals.
[[nodiscard]] std::unique_ptr<CheckReport> make_check_text(TextSink sink, TextColour colour);

/// Returns a report that is one JSON object: all files, each with its findings, and the totals
/// (doc/check.schema.json).
[[nodiscard]] std::unique_ptr<CheckReport> make_check_json(TextSink sink);

/// Returns a line of JSON for each file, the same object as in make_check_json(), as soon as it is
/// done; the last line holds the totals.
[[nodiscard]] std::unique_ptr<CheckReport> make_check_ndjson(TextSink sink);

/// Returns the JSON Schema of make_check_json(): doc/check.schema.json. The lines of
/// make_check_ndjson() are its "mesh".
[[nodiscard]] std::string check_json_schema();

/// Returns a log in SARIF 2.1.0 (OASIS), which code hosts show beside the files. The rules are the
/// defect codes, the limits, and one of files that cannot be read.
[[nodiscard]] std::unique_ptr<CheckReport> make_check_sarif(TextSink sink);

/// Returns a test suite in the XML of JUnit, which CI systems read: one case for each file, which
/// fails if the mesh is not good, and is in error if it cannot be read. The head counts all cases,
/// so the report is written when all are known.
[[nodiscard]] std::unique_ptr<CheckReport> make_check_junit(TextSink sink);

/// Returns a report of workflow commands of GitHub Actions, which become annotations of the files;
/// the totals are a notice.
[[nodiscard]] std::unique_ptr<CheckReport> make_check_github(TextSink sink);

}  // namespace meshalyzer
