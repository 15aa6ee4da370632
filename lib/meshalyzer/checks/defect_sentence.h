#pragma once

#include "meshalyzer/defects/defect.h"
#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <optional>
#include <string>

namespace meshalyzer {

/// Returns a sentence without full stop that says which elements a defect concerns and what is
/// wrong with them.
///
/// @param is_at_least  Tells whether the search for such defects ended early, so that the defect
///                     may be larger.
[[nodiscard]] std::string defect_sentence(const Defect& defect, const Soup& soup, bool is_at_least);

/// Returns the line of the record that the sentence names first, or nothing if the file has no
/// lines.
[[nodiscard]] std::optional<std::size_t> defect_line(const Defect& defect, const Soup& soup);

/// Returns the line of a record, or nothing if the file has no lines.
///
/// @param lines  Soup::vertex_lines or Soup::face_lines.
[[nodiscard]] std::optional<std::size_t> record_line(const std::vector<std::uint32_t>& lines,
                                                     Index record);

}  // namespace meshalyzer
