#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace meshalyzer {

/// The bytes of a file: mapped where it is a regular file, else read to its end.
class FileContent {
 public:
  /// @param path  "-" reads standard input; a pipe or device is read as a stream.
  /// @throws IoError if the file cannot be opened or read, or is a directory.
  explicit FileContent(const std::string& path);
  ~FileContent();
  FileContent(const FileContent&) = delete;
  FileContent& operator=(const FileContent&) = delete;

  /// Valid as long as this object. While mapped, the file must not be cut short by anyone.
  [[nodiscard]] std::string_view bytes() const { return bytes_; }

 private:
  void* mapping_ = nullptr;
  std::size_t mapped_bytes_ = 0;
  std::string buffer_;
  std::string_view bytes_;
};

/// Puts `bytes` in the place of the file at `path`, all of them or none: a FileReplacement of one
/// piece.
///
/// @throws IoError if that fails.
void replace_file(const std::string& path, std::string_view bytes);

}  // namespace meshalyzer
