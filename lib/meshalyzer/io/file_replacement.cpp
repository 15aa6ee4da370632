#include "meshalyzer/io/file_replacement.h"

#include "meshalyzer/base/descriptor.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/file.h"

#include <cerrno>
#include <cstddef>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace meshalyzer {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 18U;
constexpr int kMaxLinks = 40;  // that the kernel follows

std::optional<struct stat> status_of(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? std::optional(status) : std::nullopt;
}

/// Gives a file the owner, the group and the permissions of another one. Only the superuser can set
/// any owner; where the group cannot be set, another group gets what all others may do.
/// @return false with errno set if the permissions cannot be set.
bool keep_access(const Descriptor& file, const struct stat& old) {
  mode_t mode = old.st_mode & 07777U;
  constexpr auto kSameOwner = static_cast<uid_t>(-1);
  if (::fchown(file.get(), old.st_uid, old.st_gid) != 0 &&
      ::fchown(file.get(), kSameOwner, old.st_gid) != 0) {
    mode = (mode & ~static_cast<mode_t>(S_IRWXG)) | (mode & S_IRWXO) << 3U;
  }
  return ::fchmod(file.get(), mode) == 0;
}

bool is_link(const std::filesystem::path& path) {
  std::error_code ignored;  // a path that cannot be examined is reported when it is opened
  return std::filesystem::is_symlink(path, ignored);
}

/// Returns what a link names.
std::filesystem::path next_target(const std::filesystem::path& link) {
  std::error_code ignored;  // the link was there a moment ago
  return link.parent_path() / std::filesystem::read_symlink(link, ignored);
}

/// Returns the descriptor that a path such as /dev/stdout names, of a file that this process has
/// open.
std::optional<int> open_descriptor(const std::string& path) {
  std::error_code ignored;  // without /proc no path names a descriptor
  const std::filesystem::path all = std::filesystem::canonical("/proc/self/fd", ignored);
  std::filesystem::path named = path;
  for (int i = 0; i < kMaxLinks && is_link(named) && !all.empty(); ++i) {
    if (std::filesystem::weakly_canonical(named.parent_path(), ignored) == all) {
      const auto number = parse_integer(named.filename().string());
      if (number) return static_cast<int>(*number);
    }
    named = next_target(named);
  }
  return std::nullopt;
}

/// A file beside the one that a path names, which it can replace; it is removed unless it has.
class NewFile {
 public:
  /// The umask applies to the new file as it would to the target.
  explicit NewFile(const std::string& path)
      : name_(path), target_(link_target(path)), descriptor_(create()) {}
  ~NewFile() {
    if (!path_.empty()) {
      ::unlink(path_.c_str());
    }
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  [[nodiscard]] const Descriptor& descriptor() const { return descriptor_; }

  void replace_target() {
    if (::fsync(descriptor_.get()) != 0 || !descriptor_.close()) {
      throw_errno(name_, "cannot be written");
    }
    if (::rename(path_.c_str(), target_.c_str()) != 0) {
      throw_errno(name_, "cannot be replaced");
    }
    path_.clear();
    flush_folder();
  }

 private:
  Descriptor create() {
    if (is_link(target_)) {
      errno = ELOOP;
      throw_errno(name_, "cannot be written");
    }
    // It is not named after the target, whose name may already have the maximum length.
    const std::filesystem::path folder = std::filesystem::path(target_).parent_path();
    const std::string stem = ".meshalyzer-" + std::to_string(::getpid());
    constexpr int kAttempts = 100;
    for (int i = 0; i < kAttempts; ++i) {
      path_ = (folder / (stem + "-" + std::to_string(i))).string();
      Descriptor file(::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
      if (file.is_open()) {
        return file;
      }
      if (errno != EEXIST) {
        break;
      }
    }
    path_.clear();
    throw_errno(name_, "cannot be written");
  }

  /// Flushes the folder, so that the renaming survives a power failure too. Some file systems
  /// cannot do this; the content is safe without it.
  void flush_folder() const {
    const std::filesystem::path folder = std::filesystem::path(target_).parent_path();
    const Descriptor opened(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_CLOEXEC));
    if (opened.is_open()) {
      ::fsync(opened.get());
    }
  }

  std::string name_;
  std::string target_;
  std::string path_;
  Descriptor descriptor_;
};

}  // namespace

std::string link_target(const std::string& path) {
  std::filesystem::path target = path;
  for (int i = 0; i < kMaxLinks && is_link(target); ++i) target = next_target(target);
  return target.string();
}

void copy_to_new_file(const std::string& from, const std::string& to) {
  const FileContent content(from);
  const std::optional<struct stat> old = status_of(from);
  constexpr int kFlags = O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC;
  Descriptor copy(::open(to.c_str(), kFlags, S_IRUSR | S_IWUSR));
  if (!copy.is_open()) throw_errno(to, "cannot be written");
  if (!old || !keep_access(copy, *old) || !write_all(copy, content.bytes()) ||
      ::fsync(copy.get()) != 0 || !copy.close()) {
    const int reason = errno;
    ::unlink(to.c_str());
    errno = reason;
    throw_errno(to, "cannot be written");
  }
}

/// One of the two ways to write: into a new file, or directly into a file that is open or not
/// regular.
class FileReplacement::Output {
 public:
  explicit Output(const std::string& path) : path_(path) {
    if (const std::optional<int> open = open_descriptor(path)) {
      direct_.emplace(::fcntl(*open, F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
      if (!direct_->is_open()) throw_errno(path, "cannot be opened");
      return;
    }
    const std::optional<struct stat> old = status_of(path);
    if (old && S_ISDIR(old->st_mode)) {
      throw IoError(path, {}, "is a directory");
    }
    if (old && !S_ISREG(old->st_mode)) {
      direct_.emplace(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
      if (!direct_->is_open()) {
        throw_errno(path, "cannot be opened");
      }
      return;
    }
    if (old && ::access(path.c_str(), W_OK) != 0) {
      throw_errno(path, "cannot be written");
    }
    new_file_.emplace(path);
    if (old && !keep_access(new_file_->descriptor(), *old)) {
      throw_errno(path, "cannot be given its permissions");
    }
  }

  void write(std::string_view bytes) {
    if (buffer_.size() + bytes.size() > kBufferBytes) {
      flush();
    }
    if (bytes.size() > kBufferBytes) {
      put(bytes);
    } else {
      buffer_ += bytes;
    }
  }

  void commit() {
    flush();
    if (new_file_) {
      new_file_->replace_target();
    } else if (!direct_->close()) {
      throw_errno(path_, "cannot be written");
    }
  }

 private:
  void flush() {
    put(buffer_);
    buffer_.clear();
  }

  void put(std::string_view bytes) {
    if (!write_all(new_file_ ? new_file_->descriptor() : *direct_, bytes)) {
      throw_errno(path_, "cannot be written");
    }
  }

  std::string path_;
  std::optional<NewFile> new_file_;
  std::optional<Descriptor> direct_;
  std::string buffer_;
};

FileReplacement::FileReplacement(const std::string& path)
    : output_(std::make_unique<Output>(path)) {}

FileReplacement::~FileReplacement() = default;
FileReplacement::FileReplacement(FileReplacement&& other) noexcept = default;
FileReplacement& FileReplacement::operator=(FileReplacement&& other) noexcept = default;

void FileReplacement::write(std::string_view bytes) {
  // The output is moved out first: after an exception nothing can be committed.
  std::unique_ptr<Output> output = take();
  output->write(bytes);
  output_ = std::move(output);
}

void FileReplacement::commit() {
  take()->commit();
}

std::unique_ptr<FileReplacement::Output> FileReplacement::take() {
  if (!output_) {
    throw InvalidArgument("the file replacement has ended already");
  }
  return std::move(output_);
}

}  // namespace meshalyzer
