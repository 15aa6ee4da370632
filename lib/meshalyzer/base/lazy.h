#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>

namespace meshalyzer {

/// Runs a function once, for the first thread that asks; all others wait until it is done.
class RunOnce {
 public:
  /// Tells whether the function has been run.
  [[nodiscard]] bool is_done() const { return is_done_.load(std::memory_order_acquire); }

  /// Runs the function unless one has run already. It may use parallel loops even when the caller
  /// is inside one: a thread that waits for them never takes work from outside (base/parallel.h),
  /// which might ask for the same value.
  ///
  /// An exception of the function is rethrown here; the next thread that asks then runs its own.
  void run(const std::function<void()>& function);

 private:
  std::mutex mutex_;
  std::atomic<bool> is_done_ = false;
};

/// A value that is computed when any of several threads first asks for it.
template <typename T>
class Lazy {
 public:
  /// Returns the value.
  ///
  /// @param make  Computes the value; it is called only when there is none yet.
  template <typename Make>
  const T& get(const Make& make) {
    if (!once_.is_done()) once_.run([&] { value_.emplace(make()); });
    return *value_;
  }

  /// Tells whether the value has been made.
  [[nodiscard]] bool is_made() const { return once_.is_done(); }

  /// Moves the value out; it must not be asked for again.
  [[nodiscard]] T take() { return std::move(*value_); }

 private:
  RunOnce once_;
  std::optional<T> value_;
};

}  // namespace meshalyzer
