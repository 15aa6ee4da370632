#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/set/set_analysis.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// A row of the index of a set: the data of a mesh that it shows.
struct IndexRow {
  std::string name;
  /// The path of its page, relative to the index, with '/' between folders.
  std::string page;
  /// The reason why the file could not be read; then there is no page, and the members below are
  /// not set.
  std::string error = {};
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
/// @param set  The findings about the set, or null if nothing was requested about it.
[[nodiscard]] std::string html_index(const std::vector<IndexRow>& rows, const SetAnalysis* set);

}  // namespace meshalyzer
