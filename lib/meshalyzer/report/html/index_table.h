#pragma once

#include "meshalyzer/report/html/index_page.h"
#include "meshalyzer/report/html/writer.h"

#include <string>
#include <vector>

namespace meshalyzer {

enum class RowState { Good, NotGood, NotJudged, Unreadable };

[[nodiscard]] RowState state_of(const IndexRow& row);

/// Appends the section with one row for each mesh: the important columns first, the counts of each
/// defect code last. A code without defects has no column, nor has a separation that was not
/// measured.
/// @param notes  The notes of each row, which follow the reasons why it is not good; the list may
///               be shorter.
void append_meshes_section(HtmlWriter& html, const std::vector<IndexRow>& rows,
                           const std::vector<std::vector<std::string>>& notes);

}  // namespace meshalyzer
