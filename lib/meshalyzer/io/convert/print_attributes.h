#pragma once

#include "meshalyzer/io/convert/mesh_attributes.h"
#include "meshalyzer/io/write.h"
#include "meshalyzer/mesh/soup.h"

#include <string>

namespace meshalyzer {

/// Prints a mesh with those of its attributes that the format has: vertices and faces in the order
/// of the soup, which reads back the same. A corner without a vertex names the first one.
[[nodiscard]] std::string print_obj_with(const MeshAttributes& attributes, const Soup& soup);
[[nodiscard]] std::string print_off_with(const MeshAttributes& attributes, const Soup& soup);
[[nodiscard]] std::string print_ply_with(const MeshAttributes& attributes, const Soup& soup,
                                         Encoding encoding);

/// Returns the texture coordinates of each vertex, where no vertex has different ones at its
/// corners, and every face has some; else nothing.
[[nodiscard]] std::vector<TexturePoint> texture_of_vertices(const MeshAttributes& attributes,
                                                            const Soup& soup);

/// Tells whether bytes can say these colours, but for what three decimals leave open.
[[nodiscard]] bool are_bytes(const std::vector<std::optional<Rgba>>& colours);

/// Tells whether any of these colours lets light through.
[[nodiscard]] bool have_opacity(const std::vector<std::optional<Rgba>>& colours);

}  // namespace meshalyzer
