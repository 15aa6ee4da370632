#pragma once

#include "meshalyzer/report/html/page.h"
#include "meshalyzer/report/html/writer.h"

#include <string>
#include <vector>

namespace meshalyzer {

enum class RowState { Good, NotGood, NotJudged, Unreadable };

[[nodiscard]] RowState state_of(const IndexRow& row);

/// Appends the section with a row a mesh: what matters first, the counts of each code of defects
/// last. Codes that no mesh has a defect of have no column, nor has the separation where it was not
/// measured.
/// @param notes  By row: what else there is to say of it, after why it is not good; may be shorter.
void append_meshes_section(HtmlWriter& html, const std::vector<IndexRow>& rows,
                           const std::vector<std::vector<std::string>>& notes);

}  // namespace meshalyzer
