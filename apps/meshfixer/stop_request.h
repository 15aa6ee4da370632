#pragma once

#include "interrupt.h"
#include "meshalyzer/base/deadline.h"

#include <optional>
#include <string>

namespace meshalyzer::fixer {

/// Tells when a repair must end early: at its time limit, or at the first interrupt; a second
/// interrupt ends the program at once.
class StopRequest {
 public:
  /// @param time_limit  The time in seconds from now.
  explicit StopRequest(std::optional<double> time_limit) : deadline_(time_limit) {}

  [[nodiscard]] bool is_made() const;

  /// Returns the note in the report of a repair that was stopped.
  [[nodiscard]] static std::string note();

 private:
  InterruptGuard guard_;
  Deadline deadline_;
};

}  // namespace meshalyzer::fixer
