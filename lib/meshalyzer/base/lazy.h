#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>

namespace meshalyzer {

/// Runs a function for the first thread that comes; all others wait until it is done.
class RunOnce {
 public:
  /// Tells whether the function has been run.
  [[nodiscard]] bool is_done() const { return is_done_.load(std::memory_order_acquire); }

  /// Runs the function unless one has been run. It may use parallel loops, also where the caller is
  /// in one itself: a thread that waits for them never takes up work that came from outside.
  ///
  /// What the function throws, this throws; then the next thread that comes runs its own.
  void run(const std::function<void()>& function);

 private:
  std::mutex mutex_;
  std::atomic<bool> is_done_ = false;
};

/// A value that is made when it is first asked for, by any of several threads.
template <typename T>
class Lazy {
 public:
  /// The value.
  ///
  /// @param make  Returns the value; it is only called where there is none yet.
  template <typename Make>
  const T& get(const Make& make) {
    if (!once_.is_done()) once_.run([&] { value_.emplace(make()); });
    return *value_;
  }

  /// Tells whether the value has been made.
  [[nodiscard]] bool is_made() const { return once_.is_done(); }

  /// Takes the value away, which must not be asked for again.
  [[nodiscard]] T take() { return std::move(*value_); }

 private:
  RunOnce once_;
  std::optional<T> value_;
};

}  // namespace meshalyzer
