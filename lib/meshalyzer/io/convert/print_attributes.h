#pragma once

#include "meshalyzer/io/convert/mesh_attributes.h"
#include "meshalyzer/io/write.h"
#include "meshalyzer/mesh/soup.h"

#include <string>

namespace meshalyzer {

/// Prints a mesh as OBJ with the attributes that this format has, vertices and faces in the order
/// of the soup, so that it reads back the same. A corner without a vertex names the first one. The
/// other functions do so for their formats.
[[nodiscard]] std::string print_obj_with(const MeshAttributes& attributes, const Soup& soup);
[[nodiscard]] std::string print_off_with(const MeshAttributes& attributes, const Soup& soup);
[[nodiscard]] std::string print_ply_with(const MeshAttributes& attributes, const Soup& soup,
                                         Encoding encoding);

/// Returns the texture coordinates of each vertex if no vertex has different ones at its corners
/// and every face has some; else nothing.
[[nodiscard]] std::vector<TexturePoint> texture_of_vertices(const MeshAttributes& attributes,
                                                            const Soup& soup);

/// Tells whether bytes can represent these colours, to three decimals.
[[nodiscard]] bool are_bytes(const std::vector<std::optional<Rgba>>& colours);

/// Tells whether any of these colours is transparent.
[[nodiscard]] bool have_opacity(const std::vector<std::optional<Rgba>>& colours);

}  // namespace meshalyzer
