#include "file_identity.h"

#include "meshalyzer/io/file_replacement.h"

#include <filesystem>
#include <sys/stat.h>
#include <system_error>

namespace meshalyzer {
namespace {

/// Returns the path of a file that does not exist, without links, "." and "..".
std::string location_of(const std::string& path) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(link_target(path), error);
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(absolute, error);
  return (error ? absolute.lexically_normal() : canonical).string();
}

}  // namespace

FileIdentity identity_of(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) == 0) return {status.st_dev, status.st_ino, {}};
  return {0, 0, location_of(path)};
}

bool is_same_file(const std::string& a, const std::string& b) {
  return identity_of(a) == identity_of(b);
}

}  // namespace meshalyzer
