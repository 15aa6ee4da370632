#pragma once

#include "meshalyzer/report/html/html_writer.h"
#include "meshalyzer/report/html/page.h"

#include <vector>

namespace meshalyzer {

enum class RowState { Good, NotGood, NotJudged, Unreadable };

[[nodiscard]] RowState state_of(const IndexRow& row);

/// Appends the section with a row a mesh. Codes that no mesh has a defect of have no column, nor
/// has the separation where it was not measured.
void append_meshes_section(HtmlWriter& html, const std::vector<IndexRow>& rows);

}  // namespace meshalyzer
