#include "meshalyzer/set/file_stamp.h"

#include <sys/stat.h>

namespace meshalyzer {

FileStamp stamp_of(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    return {};
  }
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
  return {static_cast<std::uint64_t>(status.st_size),
          static_cast<std::int64_t>(status.st_mtim.tv_sec) * kNanoseconds +
              static_cast<std::int64_t>(status.st_mtim.tv_nsec)};
}

}  // namespace meshalyzer
