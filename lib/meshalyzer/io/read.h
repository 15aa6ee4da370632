#pragma once

#include "meshalyzer/mesh/soup.h"

#include <string>
#include <string_view>

namespace meshalyzer {

/// Reads a mesh file.
///
/// The format is that of the name's ending (.mesh .obj .off .stl .ply, any case), unless the
/// content is certainly that of another one; `.mesh` is INRIA's if the content begins with
/// MeshVersionFormatted, and a file with another ending is read as the format that its content
/// looks like. Any of them may be gzipped, and may begin with a byte order mark. See doc/formats.md
/// for each grammar.
///
/// @param path  The file; "-" reads standard input.
/// @throws IoError with the file and line (binary: byte offset) of the first fault.
/// @complexity O(bytes) time and memory, whatever a header claims.
[[nodiscard]] Soup read_mesh(const std::string& path);

/// Parses content in memory; `name` appears in messages and determines the format as a path would.
[[nodiscard]] Soup parse_mesh(std::string_view content, const std::string& name);

}  // namespace meshalyzer
