#include "meshalyzer/base/lazy.h"

#include <tbb/task_arena.h>

namespace meshalyzer {

void RunOnce::run(const std::function<void()>& function) {
  const std::lock_guard lock(mutex_);
  if (is_done_.load(std::memory_order_relaxed)) return;
  // Without isolation a thread that waits for the end of a loop in `function` might take a task
  // that asks for the same value, and wait for itself.
  tbb::this_task_arena::isolate(function);
  is_done_.store(true, std::memory_order_release);
}

}  // namespace meshalyzer
