#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace meshalyzer {

/// The base class of all exceptions of the library. Mesh defects are never thrown: they are
/// returned.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A caller broke a documented precondition.
class InvalidArgument : public Error {
 public:
  using Error::Error;
};

/// The place of a fault in a file.
struct FilePlace {
  /// 1-based line of the fault; 0 when it has none (binary content, file not opened).
  std::size_t line = 0;
  /// 0-based byte offset of the fault in binary content; kNoByte when the content is text.
  std::size_t byte = kNoByte;
  static constexpr std::size_t kNoByte = static_cast<std::size_t>(-1);
};

/// A file could not be opened or written, or its content is not of its format.
///
/// what() reads `FILE:LINE: what is wrong`, or `FILE:byte OFFSET: ...` for binary content, or
/// `FILE: ...`, on one line: control characters in the name of the file are "?".
class IoError : public Error {
 public:
  IoError(const std::string& file, FilePlace place, const std::string& what);

  [[nodiscard]] const std::string& file() const noexcept { return file_; }
  [[nodiscard]] FilePlace place() const noexcept { return place_; }
  /// What is wrong, without the file and the place.
  [[nodiscard]] const std::string& reason() const noexcept { return reason_; }

 private:
  std::string file_;
  std::string reason_;
  FilePlace place_;
};

}  // namespace meshalyzer
