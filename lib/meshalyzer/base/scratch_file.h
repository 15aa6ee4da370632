#pragma once

#include "meshalyzer/base/descriptor.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace meshalyzer {

/// Stores doubles in an unnamed file, which vanishes when it is closed, however the program ends.
class ScratchFile {
 public:
  /// Makes the file in the folder that the environment variable TMPDIR names, or else in /tmp.
  /// @throws IoError if no file can be made there.
  ScratchFile();

  [[nodiscard]] std::size_t size() const { return size_; }

  /// @throws IoError if that fails; the file then keeps its former content.
  void append(std::span<const double> values);

  /// Returns the `n` values from number `first` on, counted from 0; they must exist.
  /// @throws IoError if that fails.
  [[nodiscard]] std::vector<double> read(std::size_t first, std::size_t n) const;

 private:
  std::string folder_;
  Descriptor file_;
  std::size_t size_ = 0;
};

}  // namespace meshalyzer
