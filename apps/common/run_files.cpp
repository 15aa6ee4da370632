#include "run_files.h"

#include "usage_error.h"

#include <filesystem>
#include <system_error>

namespace meshalyzer {
namespace {

/// Tells whether a path names nothing that could be overwritten: a standard stream, a pipe or a
/// device.
bool is_stream(const std::string& path) {
  std::error_code ignored;  // a path that cannot be examined is reported when it is opened
  return path == "-" || std::filesystem::is_other(path, ignored);
}

}  // namespace

void RunFiles::add_input(const std::string& path) {
  if (!is_stream(path)) inputs_.insert(identity_of(path));
}

void RunFiles::add_output(const std::string& path, const std::string& what) {
  if (is_stream(path)) return;
  const FileIdentity file = identity_of(path);
  if (inputs_.count(file) != 0) {
    throw UsageError(path + " would be written, but it is an input, which never changes");
  }
  const auto [other, is_new] = outputs_.emplace(file, what);
  if (!is_new) {
    throw UsageError(other->second + " and " + what + " would both be written to " + path);
  }
}

}  // namespace meshalyzer
