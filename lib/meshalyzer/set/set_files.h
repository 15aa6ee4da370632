#pragma once

#include "meshalyzer/set/file_stamp.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// Returns the names of the meshes of a set in its report: the last part of their paths where these
/// differ, else the paths.
[[nodiscard]] std::vector<std::string> set_names(const std::vector<std::string>& paths);

/// The files of a set in the state that a run finds them in.
struct SetFiles {
  std::vector<std::string> paths;
  /// The names of the meshes in the report, see set_names().
  std::vector<std::string> names;
  std::vector<FileStamp> stamps;
  /// A digest of all paths and stamps: where one differs, so does this.
  std::string fingerprint;
};

/// Returns the files as they are now. A file that may not be read has a stamp of 0, since leave to
/// do so changes neither its size nor its time.
[[nodiscard]] SetFiles stamped(const std::vector<std::string>& paths);

/// @throws IoError where a file is not there any more, or is not what it was.
void require_unchanged(const SetFiles& files);

}  // namespace meshalyzer
