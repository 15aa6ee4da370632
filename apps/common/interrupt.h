#pragma once

namespace meshalyzer {

/// While it lives, the first interrupt of the user (Ctrl-C, or a polite kill) only leaves a mark,
/// so that work can be ended in order; the second ends the program at once. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] static bool is_interrupted();
};

}  // namespace meshalyzer
