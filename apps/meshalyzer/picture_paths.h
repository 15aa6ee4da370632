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
  /// A file a mesh, or empty where none was asked for.
  std::vector<std::string> pages;
  std::vector<std::string> fields;
  std::vector<std::string> separations;
  /// The folders for several pages, fields or separations, which are made when the first file in
  /// them is written.
  std::vector<std::string> folders;
  /// The index of the pages; absent where there is one mesh, or no page.
  std::optional<std::string> index;
  /// The address of each page in the index.
  std::vector<std::string> links;
};

/// Names all pictures that a run writes. For one mesh, a page or a field has the name that was
/// given. For several, pages are in a folder called as FILE without its ending and with `_pages`,
/// fields in one called as FILE without its ending; in them they are called as the last parts of
/// the paths of the meshes with their own ending in place where these differ, else by the number of
/// the mesh, `_` and its last part.
///
/// @throws UsageError  where FILE has not the ending of what is written, where a picture or the
/// JSON report would take the place of an input, or where meshes with a field would come among
/// those of a folder that is looked at.
[[nodiscard]] PicturePaths picture_paths(const Options& options, const Inputs& inputs);

/// Makes a folder, and all above it, where it is not there.
/// @throws IoError if that fails.
void make_folder(const std::string& folder);

}  // namespace meshalyzer
