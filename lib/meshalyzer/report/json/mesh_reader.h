#pragma once

#include "meshalyzer/analysis/analysis.h"

#include <string_view>

namespace meshalyzer {

/// Reads back what is known of a mesh from its JSON: an element of "meshes" in a report, or a line
/// that holds the same members.
///
/// The reports of the result are those of the analysis that was written, byte for byte: text and
/// JSON, but for the positions of -q; with the offending elements where the JSON lists them. Only
/// what no report says is lost. Records that nothing names have no index: `vertex_ids` and
/// `face_ids` hold the ids that occur, ascending.
///
/// @param object_text  One JSON object; members that are none of a mesh do not matter.
/// @throws InvalidArgument  Not such an object; the message tells which member is wrong.
/// @complexity  O(n log n) in the length of the text, dozens of ns a byte.
[[nodiscard]] Analysis read_mesh_json(std::string_view object_text);

}  // namespace meshalyzer
