#pragma once

#include "meshalyzer/repair/fix_defects.h"

#include <string>

namespace meshalyzer::fixer {

// The parsers for the values of options. All throw UsageError if the text is no valid value.

/// The codes of a list with commas.
struct CodeList {
  DefectCodes codes;
  /// Those that the list names, not only includes in `all` or `default`.
  DefectCodes named;
};

[[nodiscard]] CodeList to_codes(const std::string& text, const std::string& option);
/// Parses "X,Y,Z".
[[nodiscard]] Vec3 to_point(const std::string& text, const std::string& option);
[[nodiscard]] FillShape to_fill_shape(const std::string& text, const std::string& option);
/// Parses a length, or a share of the diagonal as in "0.1%".
[[nodiscard]] Deviation to_deviation(const std::string& text, const std::string& option);
/// Parses an angle in degrees, 0 to 180.
[[nodiscard]] double to_foldover_angle(const std::string& text, const std::string& option);
/// Parses the file of a page.
[[nodiscard]] std::string to_page(const std::string& text, const std::string& option);
/// Parses the file of a mesh, with the ending of a known format, or "-", or the name of a folder.
[[nodiscard]] std::string to_output(const std::string& text, const std::string& option);
/// Tells whether an output is a folder by its name: it ends with a slash, or has no ending.
[[nodiscard]] bool is_folder_name(const std::string& text);

}  // namespace meshalyzer::fixer
