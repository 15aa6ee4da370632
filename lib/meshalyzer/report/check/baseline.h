#pragma once

#include "meshalyzer/checks/known_findings.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// Reads the findings of an earlier check from its JSON report.
///
/// @throws IoError  if the file is no such report, or does not list all findings.
[[nodiscard]] std::vector<KnownFinding> read_baseline(const std::string& path);

}  // namespace meshalyzer
