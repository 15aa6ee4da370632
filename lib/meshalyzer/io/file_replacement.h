#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace meshalyzer {

/// Returns the path of the file that a path names, which need not exist: symbolic links are
/// followed. Where they lead in a circle it is the path of one of them.
[[nodiscard]] std::string link_target(const std::string& path);

/// Copies a file, with its owner, group and permissions as FileReplacement keeps them, to a path at
/// which there must be nothing. There is no copy unless it is whole.
///
/// @throws IoError if that fails.
void copy_to_new_file(const std::string& from, const std::string& to);

/// Replaces the content of a file atomically, written piece by piece.
///
/// The bytes go to a new file in the same folder, which commit() flushes to the disk and renames;
/// without commit() it is removed and the old file stays. An existing file keeps its permissions,
/// and its owner and group where the user may set them; a symbolic link keeps pointing to its file,
/// which need not exist. A file that is not regular (a pipe, a device) is written directly, which
/// cannot be undone; so is one that the process has open already, if it is named as such
/// (/dev/stdout): it goes on where it is.
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

  /// Makes the written bytes the content of the file.
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
