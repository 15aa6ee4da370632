#pragma once

namespace meshalyzer {

/// While it exists, the first interrupt (SIGINT or SIGTERM) only sets a flag, so that work can end
/// in order; the second ends the program at once. Only one may exist at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] static bool is_interrupted();
};

}  // namespace meshalyzer
