#include "meshalyzer/io/file.h"

#include "meshalyzer/base/descriptor.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/io/file_replacement.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace meshalyzer {
namespace {

std::string read_stream(int fd, const std::string& path) {
  constexpr std::size_t kBlock = std::size_t{1} << 20U;
  std::string content;
  for (;;) {
    const std::size_t size = content.size();
    content.resize(size + kBlock);
    const ssize_t n = ::read(fd, content.data() + size, kBlock);
    content.resize(size + (n > 0 ? static_cast<std::size_t>(n) : 0));
    if (n == 0) {
      return content;
    }
    if (n < 0 && errno != EINTR) {
      throw_errno(path, "cannot be read");
    }
  }
}

}  // namespace

FileContent::FileContent(const std::string& path) {
  const Descriptor file(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (!file.is_open() || ::fstat(file.get(), &status) != 0) {
    throw_errno(path, "cannot be opened");
  }
  if (S_ISDIR(status.st_mode)) {
    throw IoError(path, {}, "is a directory");
  }
  if (S_ISREG(status.st_mode) && status.st_size > 0 && path != "-") {
    const auto size = static_cast<std::size_t>(status.st_size);
    void* mapping = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.get(), 0);
    if (mapping != MAP_FAILED) {
      mapping_ = mapping;
      mapped_bytes_ = size;
      bytes_ = {static_cast<const char*>(mapping), size};
      return;
    }
  }
  buffer_ = read_stream(file.get(), path);
  bytes_ = buffer_;
}

FileContent::~FileContent() {
  if (mapping_ != nullptr) {
    ::munmap(mapping_, mapped_bytes_);
  }
}

void replace_file(const std::string& path, std::string_view bytes) {
  FileReplacement file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace meshalyzer
