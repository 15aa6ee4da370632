#pragma once

#include "meshalyzer/analysis/analysis.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace meshalyzer {

/// The length of names: long ones are shortened in the middle to fit on a terminal, or stay whole,
/// for programs.
enum class NameLength : std::uint8_t { Fitted, Whole };

/// Returns the width of the first column of a summary: that of the longest name, at least 8
/// characters, fitted at most 40.
[[nodiscard]] std::size_t summary_width(std::span<const std::string> names, NameLength length);

/// Returns the titles of a summary, which has one line for each mesh, aligned although each can be
/// printed as soon as it is known. A line has about 80 characters and the name, then the first
/// reason why the mesh is not good.
/// @param width  See summary_width().
[[nodiscard]] std::string summary_header(std::size_t width);

/// Returns the line of a mesh. Undefined and not requested values are "-".
/// @param name  The name; one longer than `width` is shortened in the middle.
[[nodiscard]] std::string summary_line(std::string_view name, const Analysis& analysis,
                                       std::size_t width);

/// Returns the line of a file that could not be read.
[[nodiscard]] std::string summary_of_unreadable(std::string_view name, std::string_view why,
                                                std::size_t width);

}  // namespace meshalyzer
