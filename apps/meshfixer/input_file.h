#pragma once

#include "meshalyzer/io/file.h"
#include "meshalyzer/io/plain_content.h"

#include <string>

namespace meshalyzer::fixer {

/// A mesh file in memory: its bytes, and the unpacked content.
class InputFile {
 public:
  /// @throws IoError if it cannot be read or unpacked.
  explicit InputFile(const std::string& path)
      : path_(path), content_(path), plain_(content_.bytes(), path) {}

  /// The path as the user named it.
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string_view original() const { return content_.bytes(); }
  [[nodiscard]] const PlainContent& plain() const { return plain_; }
  [[nodiscard]] std::string_view bytes() const { return plain_.bytes(); }

 private:
  std::string path_;
  FileContent content_;
  PlainContent plain_;
};

}  // namespace meshalyzer::fixer
