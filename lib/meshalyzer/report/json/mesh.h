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
/// The members hold everything in the reports of the mesh except the positions that
/// OffenderStyle::CustomPoints needs, so that read_mesh_members() gives the same reports.
void write_mesh_members(JsonWriter& json, const Analysis& analysis, JsonOffenders offenders);

/// Reads back an analysis from the JSON of a mesh: an element of "meshes" in a report, or a line
/// that holds the same members.
///
/// The reports of the result equal those of the analysis that was written, byte for byte: text and
/// JSON, except custom points; with the offending elements if the JSON lists them. Only data that
/// no report shows is lost. Records that nothing names have no index: `vertex_ids` and `face_ids`
/// hold the ids that occur, ascending.
///
/// @param object_text  One JSON object, whose unknown members are ignored.
/// @throws InvalidArgument  if it is no such object; the message names the wrong member.
/// @complexity  O(n log n) in the length of the text, dozens of ns a byte.
[[nodiscard]] Analysis read_mesh_members(std::string_view object_text);

/// Defines "mesh" and its parts.
void define_mesh(SchemaDefinitions& schema);

}  // namespace meshalyzer
