#pragma once

#include "file_identity.h"

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {

/// A set of existing files, identified by device and inode, not by name.
class KnownFiles {
 public:
  /// @param paths  The paths; those without a file are ignored.
  explicit KnownFiles(const std::vector<std::string>& paths);

  /// Tells whether a path names one of the files, possibly through links.
  [[nodiscard]] bool contain(const std::string& path) const;

 private:
  /// The device and the inode number of each file.
  std::set<std::pair<std::uint64_t, std::uint64_t>> files_;
};

}  // namespace meshalyzer
