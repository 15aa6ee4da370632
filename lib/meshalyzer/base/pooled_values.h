#pragma once

#include "meshalyzer/base/statistics.h"

#include <cstddef>
#include <memory>
#include <span>

namespace meshalyzer {

/// The values of one quantity over all objects of a set, and their statistics, in memory that does
/// not grow with their number: values beyond the buffer go to an unnamed temporary file (in the
/// folder TMPDIR, else /tmp) that vanishes with this object.
///
/// An object that was moved from may only be destroyed or assigned to.
class PooledValues {
 public:
  static constexpr std::size_t kDefaultBufferBytes = std::size_t{4} << 20U;

  /// @param buffer_bytes  The size of the buffer, rounded to whole chunks of parallel_chunks(), at
  ///     least one.
  explicit PooledValues(std::size_t buffer_bytes = kDefaultBufferBytes);
  ~PooledValues();
  PooledValues(PooledValues&& other) noexcept;
  PooledValues& operator=(PooledValues&& other) noexcept;

  /// Appends values. The result does not depend on how they are distributed over the calls.
  ///
  /// @param values  The values, without NaN.
  /// @throws IoError if the temporary file cannot be written, with its folder as the file.
  void append(std::span<const double> values);

  /// Returns the same bits that summarize() gives for all the values in the order in which they
  /// were added.
  ///
  /// @throws IoError if the temporary file cannot be read.
  /// @complexity  O(n) time: at most six passes over the values. It takes the memory of the buffer
  ///              once more, and 2 MB.
  [[nodiscard]] Statistics summarize() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace meshalyzer
