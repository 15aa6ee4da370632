#pragma once

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/checks/finding.h"

#include <cstddef>
#include <string>

namespace meshalyzer {

/// Where a finding is: "cow.obj:628", or only the path where the format has no lines.
[[nodiscard]] std::string place_of(const FileFindings& file, const Finding& finding);

/// Where an unreadable file is wrong: "cow.obj:17", "cow.stl:byte 84", or only the path.
[[nodiscard]] std::string place_of_trouble(const FileFindings& file);

/// What is wrong, and what mends it in brackets.
[[nodiscard]] std::string message_of(const Finding& finding);

/// Returns how many findings of a code are not listed.
[[nodiscard]] std::size_t n_left_out(const FileFindings& file, const FindingCount& found);

/// "... and 35 more", "... and at least 35 more".
[[nodiscard]] std::string left_out_of(const FileFindings& file, const FindingCount& found);

/// What a person should know of a file that is no finding: that its name says another format than
/// its content. Mostly empty.
[[nodiscard]] std::string note_of(const FileFindings& file);

/// The code of files that cannot be read.
inline constexpr std::string_view kUnreadable = "unreadable";

}  // namespace meshalyzer
