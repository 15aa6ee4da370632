#pragma once

#include "meshalyzer/report/refusal_groups.h"
#include "meshalyzer/report/repair_report.h"
#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/list_length.h"

#include <cstddef>
#include <string>
#include <vector>

namespace meshalyzer {

/// Appends ", largest move 0.5" if anything was moved.
void append_distance(std::string& text, double distance);

/// Describes what a run of a pass did: "2 changes, 1 face removed, ...".
[[nodiscard]] std::string step_text(const LogStep& step);

/// Appends the outcome: files, notes, sizes, deviations.
void append_outcome(LineSink& lines, const RepairReport& report);

/// Returns the losses in one line: "33963 texture coordinates, 5 materials".
[[nodiscard]] std::string lost_text(const std::vector<AttributeCount>& lost);

/// Appends the places that a pass left unchanged, with the reason.
void append_refusal(LineSink& lines, const RefusalGroup& group, ListLength lists);

/// Returns the path of one of several meshes, or its number if it was not written.
[[nodiscard]] std::string mesh_text(const RepairReport& report, std::size_t mesh);

}  // namespace meshalyzer
