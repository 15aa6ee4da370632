#include "meshalyzer/base/parallel_in_order.h"

#include "meshalyzer/base/parallel.h"

#include <atomic>
#include <exception>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

namespace meshalyzer {
namespace {

/// The state that the three stages of the pipeline share.
class Line {
 public:
  Line(std::size_t n, std::size_t at_once) : end_(n), failures_(at_once) {}

  /// Returns the next item to make, or nothing when no more are wanted.
  std::optional<std::size_t> begin_next() {
    return is_wanted(next_) ? std::optional(next_++) : std::nullopt;
  }

  void make(std::size_t i, const std::function<void(std::size_t)>& body) {
    if (!is_wanted(i)) {
      return;
    }
    try {
      tbb::this_task_arena::isolate([&] { body(i); });
    } catch (...) {
      failures_[i % failures_.size()] = std::current_exception();
      end_after(i);
    }
  }

  void use(std::size_t i, const std::function<Next(std::size_t)>& body) {
    if (!is_wanted(i)) {
      return;
    }
    try {
      if (failures_[i % failures_.size()]) {
        std::rethrow_exception(failures_[i % failures_.size()]);
      }
      if (tbb::this_task_arena::isolate([&] { return body(i); }) == Next::Stop) {
        end_after(i);
      }
    } catch (...) {
      failure_ = std::current_exception();
      end_after(i);
    }
  }

  void rethrow_failure() const {
    if (failure_) {
      std::rethrow_exception(failure_);
    }
  }

 private:
  [[nodiscard]] bool is_wanted(std::size_t i) const { return i < end_; }

  void end_after(std::size_t i) {
    std::size_t end = end_;
    while (i + 1 < end && !end_.compare_exchange_weak(end, i + 1)) {
    }
  }

  /// Items from this one on are no longer wanted; the number only ever falls.
  std::atomic<std::size_t> end_;
  std::size_t next_ = 0;
  /// The exceptions of `make`, kept until the item's turn, so that always the first one in order is
  /// thrown.
  std::vector<std::exception_ptr> failures_;
  std::exception_ptr failure_;
};

void run_in_turn(std::size_t n, const std::function<void(std::size_t)>& make,
                 const std::function<Next(std::size_t)>& use) {
  for (std::size_t i = 0; i < n; ++i) {
    make(i);
    if (use(i) == Next::Stop) return;
  }
}

}  // namespace

void run_in_order(std::size_t n, std::size_t at_once, const std::function<void(std::size_t)>& make,
                  const std::function<Next(std::size_t)>& use) {
  if (n <= 1 || max_threads() == 1) {
    run_in_turn(n, make, use);
    return;
  }
  Line line(n, at_once);
  const auto begin_item = [&](tbb::flow_control& control) {
    const std::optional<std::size_t> i = line.begin_next();
    if (!i) {
      control.stop();
    }
    return i.value_or(n);
  };
  const auto make_item = [&](std::size_t i) {
    line.make(i, make);
    return i;
  };
  const auto use_item = [&](std::size_t i) { line.use(i, use); };
  using tbb::filter_mode;
  tbb::parallel_pipeline(
      at_once, tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, begin_item) &
                   tbb::make_filter<std::size_t, std::size_t>(filter_mode::parallel, make_item) &
                   tbb::make_filter<std::size_t, void>(filter_mode::serial_in_order, use_item));
  line.rethrow_failure();
}

}  // namespace meshalyzer
