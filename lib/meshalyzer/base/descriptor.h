#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace meshalyzer {

/// A file descriptor that closes itself; the standard streams stay open.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&&) = delete;

  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool is_open() const { return fd_ >= 0; }
  /// Closes the descriptor now, while a failure can still be reported.
  /// @return false with errno set if that fails.
  [[nodiscard]] bool close();

 private:
  int fd_;
};

/// Writes all of `bytes` at the file's current position.
/// @return false with errno set if that fails; some of them may have been written then.
[[nodiscard]] bool write_all(const Descriptor& file, std::string_view bytes);

/// Throws the IoError that reads `path: what: text of errno`.
[[noreturn]] void throw_errno(const std::string& path, const std::string& what);

}  // namespace meshalyzer
