#pragma once

#include "meshalyzer/base/statistics.h"

#include <cstddef>
#include <memory>
#include <span>

namespace meshalyzer {

/// The values of one quantity over all objects of a set, and their statistics, in memory that does
/// not grow with their number: what the buffer cannot hold goes to a temporary file (in the folder
/// TMPDIR, else /tmp) that has no name and is gone with this object.
///
/// Movable; one that was moved from may only be destroyed or assigned to.
class PooledValues {
 public:
  static constexpr std::size_t kDefaultBufferBytes = std::size_t{4} << 20U;

  /// @param buffer_bytes  Rounded to whole chunks of parallel_chunks(), one at least.
  explicit PooledValues(std::size_t buffer_bytes = kDefaultBufferBytes);
  ~PooledValues();
  PooledValues(PooledValues&& other) noexcept;
  PooledValues& operator=(PooledValues&& other) noexcept;

  /// Adds values behind those that are there. How they are shared out among the calls makes no
  /// difference.
  ///
  /// @param values  Must not hold NaN.
  /// @throws IoError if the temporary file cannot be written, with its folder as the file.
  void append(std::span<const double> values);

  /// Returns the same bits that summarize() gives for all the values in the order in which they
  /// were added.
  ///
  /// @throws IoError if the temporary file cannot be read.
  /// @complexity  O(n) time: at most six passes over the values. Memory: the buffer again, and 2
  /// MB.
  [[nodiscard]] Statistics summarize() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace meshalyzer
