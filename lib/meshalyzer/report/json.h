#pragma once

#include "meshalyzer/analysis/analysis.h"

#include <span>
#include <string>

namespace meshalyzer {

/// Whether the JSON report lists the offending elements (-p).
enum class JsonOffenders { Omit, List };

/// The report as JSON (contract 4, doc/report.schema.json).
///
/// @param set  Null where a single file was analysed: then the report has no "set".
[[nodiscard]] std::string json_report(std::span<const Analysis> meshes, const SetAnalysis* set,
                                      JsonOffenders offenders);

}  // namespace meshalyzer
