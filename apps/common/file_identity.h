#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace meshalyzer {

/// Identifies a file. Two paths have equal identities if they name the same file: through links if
/// it exists, by their location if it does not.
struct FileIdentity {
  /// The device and the inode number; 0 if there is no file.
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  /// The canonical path; empty if there is a file.
  std::string path;

  friend auto operator<=>(const FileIdentity&, const FileIdentity&) = default;
};

[[nodiscard]] FileIdentity identity_of(const std::string& path);

/// Tells whether two paths name the same file, which need not exist.
[[nodiscard]] bool is_same_file(const std::string& a, const std::string& b);

}  // namespace meshalyzer
