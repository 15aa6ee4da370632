#pragma once

#include "meshalyzer/set/file_stamp.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// Returns the names of the meshes of a set in its report: the last parts of their paths if these
/// differ, else the paths.
[[nodiscard]] std::vector<std::string> set_names(const std::vector<std::string>& paths);

/// The files of a set and their state at the beginning of a run.
struct SetFiles {
  std::vector<std::string> paths;
  /// The names of the meshes in the report, see set_names().
  std::vector<std::string> names;
  std::vector<FileStamp> stamps;
  /// A digest of all paths and stamps.
  std::string fingerprint;
};

/// Returns the files as they are now. A file without read permission has a stamp of 0, because
/// granting it changes neither size nor time.
[[nodiscard]] SetFiles stamped(const std::vector<std::string>& paths);

/// Checks that no file has changed.
/// @throws IoError if a file is missing or has changed.
void require_unchanged(const SetFiles& files);

}  // namespace meshalyzer
