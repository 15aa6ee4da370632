#pragma once

#include <cstdint>
#include <string>

namespace meshalyzer {

/// Tells whether a file is still the one that it was: its size and the time of its last change.
struct FileStamp {
  std::uint64_t bytes = 0;
  /// Nanoseconds since 1970; 0 where the file cannot be looked at.
  std::int64_t modified_ns = 0;

  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// Returns the stamp of a file as it is now; all 0 where it cannot be looked at.
[[nodiscard]] FileStamp stamp_of(const std::string& path);

}  // namespace meshalyzer
