#include "meshalyzer/base/descriptor.h"

#include "meshalyzer/base/error.h"

#include <cerrno>
#include <cstddef>
#include <system_error>
#include <unistd.h>

namespace meshalyzer {

Descriptor::~Descriptor() {
  if (fd_ > STDERR_FILENO) {
    ::close(fd_);
  }
}

bool Descriptor::close() {
  return ::close(std::exchange(fd_, -1)) == 0;
}

bool write_all(const Descriptor& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(file.get(), bytes.data(), bytes.size());
    if (n >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(n));
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

void throw_errno(const std::string& path, const std::string& what) {
  throw IoError(path, {}, what + ": " + std::system_category().message(errno));
}

}  // namespace meshalyzer
