#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/picture/scene.h"
#include "meshalyzer/report/mesh_name.h"
#include "meshalyzer/set/set_analysis.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace meshalyzer {

/// The text of a page on a change of a repair.
struct PageChange {
  /// The name of the pass: "cut intersections", ...
  std::string pass;
  /// The description of the change: "faces 3 4 7 dropped", ...
  std::string text;
};

/// The text of a page on what a repair would make of a patch of intersecting faces.
struct PagePatch {
  /// The index of the patch among the defects.
  std::size_t defect = 0;
  std::string text;
};

/// A mesh with its report, defects and scene for a page. The struct only refers to them.
struct PageMesh {
  const MeshName& name;
  const DefectReport& defects;
  const Scene& scene;
  /// The texts of the scene's changes.
  std::span<const PageChange> changes = {};
  std::span<const PagePatch> patches = {};
};

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

/// A row of the index of a set: the data of a mesh that it shows.
struct IndexRow {
  std::string name;
  /// The path of its page, relative to the index, with '/' between folders.
  std::string page;
  /// The reason why the file could not be read; then there is no page, and the members below are
  /// not set.
  std::string trouble = {};
  bool good = false;
  /// The reasons why the mesh is not good; also empty if goodness was not judged.
  std::vector<std::string> reasons = {};
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::optional<double> area = {};
  std::optional<double> volume = {};
  std::array<std::size_t, kDefectCodes> defects{};
  /// The smallest distance to any other mesh; absent if it was not measured.
  std::optional<double> separation = {};
};

/// Returns the row of a mesh in the index.
[[nodiscard]] IndexRow index_row(const Analysis& analysis, const DefectReport& defects,
                                 std::string name, std::string page);

/// Returns the index page of a set, with a link to the page of each mesh.
/// @param set  The findings about the set, or null if nothing was asked about it.
[[nodiscard]] std::string html_index(const std::vector<IndexRow>& rows, const SetAnalysis* set);

/// Returns the page that shows the defects of a mesh.
/// @param asked  The codes that count in the verdict.
[[nodiscard]] std::string html_report(const PageMesh& mesh, const DefectCodes& asked);

}  // namespace meshalyzer
