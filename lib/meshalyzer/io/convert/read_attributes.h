#pragma once

#include "meshalyzer/io/convert/mesh_attributes.h"
#include "meshalyzer/mesh/soup.h"

#include <string_view>

namespace meshalyzer {

/// Reads what a file says beside the mesh that was parsed from it, and other formats can say too.
///
/// @complexity O(bytes).
[[nodiscard]] MeshAttributes read_attributes(const Soup& soup, std::string_view bytes);

/// Returns the same of a file of one format, without its comments.
[[nodiscard]] MeshAttributes read_obj_attributes(std::string_view text);
[[nodiscard]] MeshAttributes read_off_attributes(const Soup& soup, std::string_view text);
[[nodiscard]] MeshAttributes read_ply_attributes(const Soup& soup, std::string_view content);

}  // namespace meshalyzer
