#include "meshalyzer/base/lazy.h"

namespace meshalyzer {

void RunOnce::run(const std::function<void()>& function) {
  const std::lock_guard lock(mutex_);
  if (is_done_.load(std::memory_order_relaxed)) return;
  function();
  is_done_.store(true, std::memory_order_release);
}

}  // namespace meshalyzer
