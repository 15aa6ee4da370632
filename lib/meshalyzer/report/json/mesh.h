#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/json/report.h"
#include "meshalyzer/report/json/writer.h"

namespace meshalyzer {

/// Writes the members of one element of "meshes" (contract 4); the caller has begun the object.
///
/// They hold all that the reports of the mesh say, but for the positions that -q prints:
/// read_mesh_json() makes the same reports of them.
void write_mesh_members(JsonWriter& json, const Analysis& analysis, JsonOffenders offenders);

}  // namespace meshalyzer
