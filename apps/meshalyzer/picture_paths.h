#pragma once

#include "inputs.h"
#include "options.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The paths of the pictures of a run.
struct PicturePaths {
  /// One file for each mesh, or empty if none was requested.
  std::vector<std::string> pages;
  std::vector<std::string> fields;
  std::vector<std::string> separations;
  /// The folders for several pages, fields or separations, which are made when the first file in
  /// them is written.
  std::vector<std::string> folders;
  /// The index of the pages; absent if there is only one mesh, or no page.
  std::optional<std::string> index;
  /// The address of each page in the index.
  std::vector<std::string> links;
};

/// Names all pictures that a run writes. For one mesh, a page or a field has the given name. For
/// several, pages are in a folder named like FILE without its ending and with `_pages`, fields in
/// one named like FILE without its ending. Their names there are the last parts of the paths of the
/// meshes, with the new ending, if these differ; else the number of the mesh, `_` and the last
/// part.
///
/// @throws UsageError  if the ending of FILE is wrong, or if meshes with a field would be written
///                     into a folder that is an input.
[[nodiscard]] PicturePaths picture_paths(const Options& options, const Inputs& inputs);

}  // namespace meshalyzer
