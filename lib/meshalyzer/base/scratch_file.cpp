#include "meshalyzer/base/scratch_file.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <string_view>
#include <sys/types.h>
#include <unistd.h>

namespace meshalyzer {
namespace {

std::string temporary_folder() {
  const char* folder = std::getenv("TMPDIR");
  return folder != nullptr && *folder != '\0' ? folder : "/tmp";
}

Descriptor open_unnamed(const std::string& folder) {
  std::string path = folder + "/meshalyzer-XXXXXX";
  Descriptor file(::mkostemp(path.data(), O_CLOEXEC));
  if (!file.is_open()) {
    throw_errno(folder, "a temporary file cannot be made");
  }
  ::unlink(path.c_str());
  return file;
}

off_t place_of(std::size_t value) {
  return static_cast<off_t>(value * sizeof(double));
}

}  // namespace

ScratchFile::ScratchFile() : folder_(temporary_folder()), file_(open_unnamed(folder_)) {}

void ScratchFile::append(std::span<const double> values) {
  // Seek to the end of the valid data: a failed write may have left some bytes after it.
  const std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  if (::lseek(file_.get(), place_of(size_), SEEK_SET) < 0 || !write_all(file_, bytes)) {
    throw_errno(folder_, "a temporary file cannot be written");
  }
  size_ += values.size();
}

std::vector<double> ScratchFile::read(std::size_t first, std::size_t n) const {
  std::vector<double> values(n);
  char* const bytes = reinterpret_cast<char*>(values.data());
  std::size_t done = 0;
  while (done < n * sizeof(double)) {
    const ssize_t got = ::pread(file_.get(), bytes + done, n * sizeof(double) - done,
                                place_of(first) + static_cast<off_t>(done));
    if (got > 0) {
      done += static_cast<std::size_t>(got);
    } else if (got == 0 || errno != EINTR) {
      errno = got == 0 ? EIO : errno;  // at the end: another process has truncated the file
      throw_errno(folder_, "a temporary file cannot be read");
    }
  }
  return values;
}

}  // namespace meshalyzer
