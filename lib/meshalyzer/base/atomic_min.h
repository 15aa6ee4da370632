#pragma once

#include <atomic>

namespace meshalyzer {

/// Replaces a value by another one if that is less, also while other threads do so with others.
template <typename T>
void atomic_min(T& value, T other) {
  const std::atomic_ref<T> shared(value);
  T known = shared.load(std::memory_order_relaxed);
  while (other < known && !shared.compare_exchange_weak(known, other, std::memory_order_relaxed)) {
  }
}

}  // namespace meshalyzer
