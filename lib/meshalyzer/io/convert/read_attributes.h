#pragma once

#include "meshalyzer/io/convert/mesh_attributes.h"
#include "meshalyzer/mesh/soup.h"

#include <string_view>

namespace meshalyzer {

/// Reads the attributes in a file, other than the mesh, that other formats can hold too.
///
/// @complexity O(bytes).
[[nodiscard]] MeshAttributes read_attributes(const Soup& soup, std::string_view bytes);

/// Reads the attributes of an OBJ file, without its comments. The other functions do so for their
/// formats.
[[nodiscard]] MeshAttributes read_obj_attributes(std::string_view text);
[[nodiscard]] MeshAttributes read_off_attributes(const Soup& soup, std::string_view text);
[[nodiscard]] MeshAttributes read_ply_attributes(const Soup& soup, std::string_view content);

}  // namespace meshalyzer
