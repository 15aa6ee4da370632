#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/set/set_analysis.h"

#include <span>
#include <string>

namespace meshalyzer {

/// Whether the JSON report lists the offending elements (-p).
enum class JsonOffenders { Omit, List };

/// The report as JSON (contract 4, doc/report.schema.json), all at once; see JsonReport.
///
/// @param set  Null where there is none: then the report has no "set". Its "closest" is null.
[[nodiscard]] std::string json_report(std::span<const Analysis> meshes, const SetAnalysis* set,
                                      JsonOffenders offenders);

}  // namespace meshalyzer
