#pragma once

#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/report/mesh_name.h"
#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/list_length.h"

#include <string>

namespace meshalyzer {

/// Selects the defects of a mesh that are listed.
struct ListedDefects {
  const MeshName& mesh;
  const DefectReport& report;
  /// The codes of the defects that are listed.
  DefectCodes codes = DefectCodes::all();
};

/// Returns the description of a defect without its code: its elements by file id, its position, and
/// the measured value.
/// @param mesh  The names of its elements.
[[nodiscard]] std::string defect_text(const Defect& defect, const MeshName& mesh, ListLength lists);

/// Appends the tolerances that were used, and their contradictions.
void append_tolerances(LineSink& lines, const DefectReport& report);

/// Appends a line for each defect: code, elements by file id, position, measured value. Short lists
/// have the first few of each code, and a line with the number of the others.
void append_defects(TextLines& lines, const ListedDefects& listed, ListLength lists);

}  // namespace meshalyzer
