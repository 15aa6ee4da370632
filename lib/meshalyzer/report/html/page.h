#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/picture/scene.h"
#include "meshalyzer/report/repair_report.h"
#include "meshalyzer/set/set_analysis.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace meshalyzer {

/// What a page says of a change of a repair.
struct PageChange {
  /// "cut intersections", ...
  std::string pass;
  /// "faces 3 4 7 dropped", ...
  std::string text;
};

/// A mesh as a page shows it. Only referred to.
struct PageMesh {
  const MeshName& name;
  const DefectReport& defects;
  const Scene& scene;
  /// Of each of the scene's changes.
  std::span<const PageChange> changes = {};
};

/// The page of one mesh. Only referred to.
struct MeshPage {
  const Analysis& analysis;
  PageMesh mesh;
  /// The path of the index page of a set, relative to this page, with '/' between folders; empty
  /// where there is none.
  std::string index = {};
};

/// Returns the report of a mesh as one HTML page that needs nothing beside it: the verdict, the 3D
/// view, every defect in a list, the tables with definitions, histograms.
/// @return UTF-8, the same for the same input.
[[nodiscard]] std::string html_report(const MeshPage& page);

/// A row of the index of a set: what its page needs of a mesh when the rest is forgotten.
struct IndexRow {
  std::string name;
  /// The path of its page, relative to the index, with '/' between folders.
  std::string page;
  /// Why the file could not be read; then there is no page, and nothing below.
  std::string trouble = {};
  bool good = false;
  /// The reasons why the mesh is not good; also empty where goodness was not judged.
  std::vector<std::string> reasons = {};
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::optional<double> area = {};
  std::optional<double> volume = {};
  std::array<std::size_t, kDefectCodes> defects{};
  /// The smallest distance to any other mesh; absent where it was not measured.
  std::optional<double> separation = {};
};

/// Returns the row of a mesh in the index.
[[nodiscard]] IndexRow index_row(const Analysis& analysis, const DefectReport& defects,
                                 std::string name, std::string page);

/// Returns the index page of a set, with a link to the page of each mesh.
/// @param set  Null where nothing was asked of the set as a whole.
[[nodiscard]] std::string html_index(const std::vector<IndexRow>& rows, const SetAnalysis* set);

/// The page of a repair. Only referred to.
struct RepairPage {
  const RepairReport& report;
  PageMesh before;
  /// All meshes of the result as one; its defects are those that remain.
  PageMesh after;
};

/// Returns the report of a repair as one HTML page: what was wrong, what was done, what remains,
/// the mesh before and after.
[[nodiscard]] std::string html_report(const RepairPage& page);

/// Returns the page that shows the defects of a mesh.
/// @param asked  The codes that count in the verdict.
[[nodiscard]] std::string html_report(const PageMesh& mesh, const DefectCodes& asked);

}  // namespace meshalyzer
