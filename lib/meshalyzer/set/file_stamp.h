#pragma once

#include <cstdint>
#include <string>

namespace meshalyzer {

/// The size of a file and the time of its last change, by which a changed file is recognised.
struct FileStamp {
  std::uint64_t bytes = 0;
  /// The time of the last change in nanoseconds since 1970; 0 if the file cannot be examined.
  std::int64_t modified_ns = 0;

  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// Returns the stamp of a file as it is now; all 0 if it cannot be examined.
[[nodiscard]] FileStamp stamp_of(const std::string& path);

}  // namespace meshalyzer
