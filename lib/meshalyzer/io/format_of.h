#pragma once

#include "meshalyzer/mesh/soup.h"

#include <optional>
#include <string_view>

namespace meshalyzer {

/// Whether a file name ends in this, in any case of letters.
/// @param ending  In lower case.
[[nodiscard]] bool has_ending(std::string_view name, std::string_view ending);

/// The format that the ending of a file name stands for, in any case of letters; `.mesh` is
/// Format::Mesh.
[[nodiscard]] std::optional<Format> format_of_name(std::string_view name);

/// The format that a file's content looks like: its first word, or a binary STL's size.
[[nodiscard]] std::optional<Format> format_of_content(std::string_view content);

/// Whether the content of a file of this format, which must be sound, is in the format's binary
/// encoding.
[[nodiscard]] bool is_binary(std::string_view content, Format format);

/// Whether the first word of the content is MeshVersionFormatted.
[[nodiscard]] bool is_inria(std::string_view content);

}  // namespace meshalyzer
