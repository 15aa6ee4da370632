#include "same_file.h"

#include <optional>
#include <sys/stat.h>

namespace meshalyzer {
namespace {

std::optional<std::pair<std::uint64_t, std::uint64_t>> file_of(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return std::pair<std::uint64_t, std::uint64_t>(status.st_dev, status.st_ino);
}

}  // namespace

KnownFiles::KnownFiles(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    if (const auto file = file_of(path)) files_.insert(*file);
  }
}

bool KnownFiles::contain(const std::string& path) const {
  const auto file = file_of(path);
  return file && files_.count(*file) != 0;
}

}  // namespace meshalyzer
