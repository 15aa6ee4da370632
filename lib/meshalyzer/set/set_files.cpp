#include "meshalyzer/set/set_files.h"

#include "meshalyzer/base/error.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <unistd.h>
#include <unordered_set>

namespace meshalyzer {
namespace {

FileStamp readable_stamp_of(const std::string& path) {
  return access(path.c_str(), R_OK) == 0 ? stamp_of(path) : FileStamp{};
}

/// A 64-bit FNV-1a hash (Fowler, Noll and Vo), as text.
class Fingerprint {
 public:
  void add(std::string_view text) {
    for (const char c : text) {
      hash_ = (hash_ ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    }
    hash_ = (hash_ ^ 0xffU) * 0x100000001b3ULL;
  }

  [[nodiscard]] std::string text() const {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4) {
      text += kDigits[hash_ >> shift & 0xfU];
    }
    return text;
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

}  // namespace

std::vector<std::string> set_names(const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  std::unordered_set<std::string> distinct;
  for (const std::string& path : paths) {
    names.push_back(path.substr(path.find_last_of('/') + 1));
    distinct.insert(names.back());
  }
  return distinct.size() == paths.size() ? names : paths;
}

SetFiles stamped(const std::vector<std::string>& paths) {
  SetFiles files{.paths = paths, .names = set_names(paths), .stamps = {}, .fingerprint = {}};
  std::transform(paths.begin(), paths.end(), std::back_inserter(files.stamps), readable_stamp_of);
  Fingerprint fingerprint;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    fingerprint.add(paths[i]);
    fingerprint.add(std::to_string(files.stamps[i].bytes));
    fingerprint.add(std::to_string(files.stamps[i].modified_ns));
  }
  files.fingerprint = fingerprint.text();
  return files;
}

void require_unchanged(const SetFiles& files) {
  for (std::size_t i = 0; i < files.paths.size(); ++i) {
    if (readable_stamp_of(files.paths[i]) != files.stamps[i]) {
      throw IoError(files.paths[i], {}, "is not there, or has changed since its line was written");
    }
  }
}

}  // namespace meshalyzer
