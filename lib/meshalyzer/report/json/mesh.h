#pragma once

#include "meshalyzer/analysis/analysis.h"

#include <string_view>

namespace meshalyzer {

class JsonWriter;
class SchemaDefinitions;
enum class JsonOffenders;

/// Writes the members of one element of "meshes" (doc/report.schema.json); the caller has begun the
/// object.
///
/// The members hold all that the reports of the mesh say, but for the positions that
/// OffenderStyle::CustomPoints needs: read_mesh_json() makes the same reports of them.
void write_mesh_members(JsonWriter& json, const Analysis& analysis, JsonOffenders offenders);

/// Reads back an analysis from the JSON of a mesh: an element of "meshes" in a report, or a line
/// that holds the same members.
///
/// The reports of the result are those of the analysis that was written, byte for byte: text and
/// JSON, but for custom points; with the offending elements where the JSON lists them. Only
/// what no report says is lost. Records that nothing names have no index: `vertex_ids` and
/// `face_ids` hold the ids that occur, ascending.
///
/// @param object_text  One JSON object; members that are none of a mesh do not matter.
/// @throws InvalidArgument  Not such an object; the message tells which member is wrong.
/// @complexity  O(n log n) in the length of the text, dozens of ns a byte.
[[nodiscard]] Analysis read_mesh_json(std::string_view object_text);

/// Defines "mesh", and what it consists of.
void define_mesh(SchemaDefinitions& schema);

}  // namespace meshalyzer
