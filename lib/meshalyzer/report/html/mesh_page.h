#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/html/page_mesh.h"

#include <string>

namespace meshalyzer {

/// The input of the page of one mesh. It only refers to its data.
struct MeshPage {
  const Analysis& analysis;
  PageMesh mesh;
  /// The path of the index page of a set, relative to this page, with '/' between folders; empty if
  /// there is none.
  std::string index = {};
};

/// Returns the report of a mesh as one self-contained HTML page: the verdict, the 3D view, every
/// defect in a list, the tables with definitions, histograms.
/// @return The page in UTF-8, which depends only on the input.
[[nodiscard]] std::string html_report(const MeshPage& page);

}  // namespace meshalyzer
