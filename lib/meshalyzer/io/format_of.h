#pragma once

#include "meshalyzer/mesh/soup.h"

#include <optional>
#include <string_view>

namespace meshalyzer {

/// Tells whether a file name has an ending, ignoring case.
/// @param ending  The ending in lower case.
[[nodiscard]] bool has_ending(std::string_view name, std::string_view ending);

/// The endings of mesh files, as error messages name them.
inline constexpr const char* kMeshEndings = ".mesh .obj .off .stl .ply, each also with .gz";

/// Tells whether the name is that of a gzipped file.
[[nodiscard]] bool is_gzip_name(std::string_view name);

/// Returns the format for the ending of a file name, ignoring case and a final `.gz`; `.mesh` is
/// Format::Mesh.
[[nodiscard]] std::optional<Format> format_of_name(std::string_view name);

/// Returns the format that a file's content looks like: its first word, or a binary STL's size.
[[nodiscard]] std::optional<Format> format_of_content(std::string_view content);

/// Returns the format of a file: that of its name, unless the content is certainly of another one;
/// if the name has none, the format that the content looks like.
[[nodiscard]] std::optional<Format> format_of(std::string_view content, std::string_view name);

/// Tells whether the valid content of a file of this format is in its binary encoding.
[[nodiscard]] bool is_binary(std::string_view content, Format format);

/// Tells whether a file of this name may be of this format: `.mesh` stands for two.
[[nodiscard]] bool is_named_as(std::string_view name, Format format);

}  // namespace meshalyzer
