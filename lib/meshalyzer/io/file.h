#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace meshalyzer {

/// The bytes of a file: mapped if it is a regular file, else read to its end.
class FileContent {
 public:
  /// @param path  The file; "-" is standard input, and a pipe or device is read as a stream.
  /// @throws IoError if the file cannot be opened or read, or is a directory.
  explicit FileContent(const std::string& path);
  ~FileContent();
  FileContent(const FileContent&) = delete;
  FileContent& operator=(const FileContent&) = delete;

  /// Returns the bytes, valid as long as this object. A mapped file must not be truncated
  /// meanwhile.
  [[nodiscard]] std::string_view bytes() const { return bytes_; }

 private:
  void* mapping_ = nullptr;
  std::size_t mapped_bytes_ = 0;
  std::string buffer_;
  std::string_view bytes_;
};

/// Replaces the file at `path` by `bytes`, all of them or none: a FileReplacement of one piece.
///
/// @throws IoError if that fails.
void replace_file(const std::string& path, std::string_view bytes);

}  // namespace meshalyzer
