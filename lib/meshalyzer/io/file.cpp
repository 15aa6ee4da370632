#include "meshalyzer/io/file.h"

#include "meshalyzer/base/error.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <sys/mman.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace meshalyzer {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw IoError(path, {}, what + ": " + std::system_category().message(errno));
}

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ > STDERR_FILENO) {
      ::close(fd_);
    }
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool is_open() const { return fd_ >= 0; }
  /// Closes now, where a failure still can be told.
  [[nodiscard]] bool close() {
    const int fd = fd_;
    fd_ = -1;
    return ::close(fd) == 0;
  }

 private:
  int fd_;
};

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
      fail(path, "cannot be read");
    }
  }
}

void write_all(int fd, std::string_view bytes, const std::string& path) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(n));
    } else if (errno != EINTR) {
      fail(path, "cannot be written");
    }
  }
}

std::optional<struct stat> status_of(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? std::optional(status) : std::nullopt;
}

/// A new file beside the target; removed again unless it has taken the target's place.
class TemporaryFile {
 public:
  /// The umask applies to the new file, as it would have to the target.
  explicit TemporaryFile(const std::string& target) : target_(target), descriptor_(create()) {}
  ~TemporaryFile() {
    if (!path_.empty()) {
      ::unlink(path_.c_str());
    }
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_.get(); }

  void replace_target() {
    if (::fsync(descriptor_.get()) != 0 || !descriptor_.close()) {
      fail(target_, "cannot be written");
    }
    if (::rename(path_.c_str(), target_.c_str()) != 0) {
      fail(target_, "cannot be replaced");
    }
    path_.clear();
  }

 private:
  int create() {
    // Not named after the target: a name as long as the file system allows leaves no room for more.
    const std::filesystem::path folder = std::filesystem::path(target_).parent_path();
    const std::string stem = ".meshalyzer-" + std::to_string(::getpid());
    constexpr int kAttempts = 100;
    for (int i = 0; i < kAttempts; ++i) {
      path_ = (folder / (stem + "-" + std::to_string(i))).string();
      const int fd = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (fd >= 0) {
        return fd;
      }
      if (errno != EEXIST) {
        break;
      }
    }
    path_.clear();
    fail(target_, "cannot be written");
  }

  std::string target_;
  std::string path_;
  Descriptor descriptor_;
};

void write_into(const std::string& path, std::string_view bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!file.is_open()) {
    fail(path, "cannot be opened");
  }
  write_all(file.get(), bytes, path);
  if (!file.close()) {
    fail(path, "cannot be written");
  }
}

/// So that the renaming outlives a power cut too. Some file systems cannot: the content is safe
/// without it.
void flush_folder(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const Descriptor descriptor(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_CLOEXEC));
  if (descriptor.is_open()) {
    ::fsync(descriptor.get());
  }
}

}  // namespace

FileContent::FileContent(const std::string& path) {
  const Descriptor file(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (!file.is_open() || ::fstat(file.get(), &status) != 0) {
    fail(path, "cannot be opened");
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
  const std::optional<struct stat> old = status_of(path);
  if (old && S_ISDIR(old->st_mode)) {
    throw IoError(path, {}, "is a directory");
  }
  if (old && !S_ISREG(old->st_mode)) {
    write_into(path, bytes);
    return;
  }
  if (old && ::access(path.c_str(), W_OK) != 0) {
    fail(path, "cannot be written");
  }
  std::error_code unresolvable;
  const std::filesystem::path resolved = std::filesystem::weakly_canonical(path, unresolvable);
  const std::string target = unresolvable ? path : resolved.string();
  TemporaryFile file(target);
  if (old && ::fchmod(file.descriptor(), old->st_mode & 07777U) != 0) {
    fail(path, "cannot be given its permissions");
  }
  write_all(file.descriptor(), bytes, path);
  file.replace_target();
  flush_folder(target);
}

}  // namespace meshalyzer
