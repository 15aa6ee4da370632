#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace meshalyzer {

/// Puts new bytes in the place of a file, all of them or none, written piece by piece.
///
/// They go to a new file in the same folder, which commit() flushes to the disk and renames;
/// without commit() it is removed and the old one stays as it was. An existing file keeps its
/// permissions; a symbolic link keeps pointing to its file; what is no regular file (a pipe, a
/// device) is written into, and what it has been given cannot be taken back.
class FileReplacement {
 public:
  /// @throws IoError if `path` is a directory or cannot be written.
  explicit FileReplacement(const std::string& path);
  ~FileReplacement();
  FileReplacement(FileReplacement&& other) noexcept;
  FileReplacement& operator=(FileReplacement&& other) noexcept;

  /// Adds bytes at the end, through a buffer.
  ///
  /// @throws IoError if that fails: nothing is replaced then.
  /// @throws InvalidArgument after commit(), or after an error.
  void write(std::string_view bytes);

  /// Makes what has been written the content of the file.
  ///
  /// @throws IoError if that fails: nothing is replaced then.
  /// @throws InvalidArgument after commit(), or after an error.
  void commit();

 private:
  class Output;

  std::unique_ptr<Output> take();

  /// The file being written; null after commit() or an error.
  std::unique_ptr<Output> output_;
};

}  // namespace meshalyzer
