#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {

/// Tells whether two paths name one file, be it there or not.
[[nodiscard]] bool is_same_file(const std::string& a, const std::string& b);

/// Files that are there, by what they are and not by what they are called.
class KnownFiles {
 public:
  /// @param paths  Those of which there is no file do not count.
  explicit KnownFiles(const std::vector<std::string>& paths);

  /// Tells whether a path names one of them, by whatever way.
  [[nodiscard]] bool contain(const std::string& path) const;

 private:
  /// Device and file number.
  std::set<std::pair<std::uint64_t, std::uint64_t>> files_;
};

}  // namespace meshalyzer
