#pragma once

#include "meshalyzer/checks/finding.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace meshalyzer {

/// Returns the path of a file on one line.
[[nodiscard]] std::string shown_path(const FileFindings& file);

/// Returns the place of a finding: "cow.obj:628", or only the path if the format has no lines.
[[nodiscard]] std::string place_of(const FileFindings& file, const Finding& finding);

/// Returns the line where an unreadable file is wrong, from 1; nothing if it is not known.
[[nodiscard]] std::optional<std::size_t> error_line(const FileFindings& file);

/// Returns the place where an unreadable file is wrong: "cow.obj:17", "cow.stl:byte 84", or only
/// the path.
[[nodiscard]] std::string place_of_error(const FileFindings& file);

/// Returns a sentence that says what is wrong, and in brackets what mends it.
[[nodiscard]] std::string message_of(const Finding& finding);

/// Returns "... and 35 more", "... and at least 35 more", or "... and perhaps more" where all that
/// were found are listed, but not all were searched; an empty text if all are listed.
[[nodiscard]] std::string left_out_of(const FileFindings& file, const FindingCount& found);

/// Returns a note on a file that is no finding: that its name does not match its format. It is
/// mostly empty.
[[nodiscard]] std::string note_of(const FileFindings& file);

/// The code of files that cannot be read.
inline constexpr std::string_view kUnreadable = "unreadable";

}  // namespace meshalyzer
