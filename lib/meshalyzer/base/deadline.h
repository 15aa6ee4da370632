#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

namespace meshalyzer {

/// The point in time at which work must stop.
class Deadline {
 public:
  /// @param seconds  Time from now; without a value the deadline never comes.
  explicit Deadline(std::optional<double> seconds) {
    if (!seconds) return;
    // A century is as good as no limit and overflows no clock.
    constexpr double kLongest = 3e9;
    const std::chrono::duration<double> length(std::min(*seconds, kLongest));
    end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(length);
  }

  [[nodiscard]] bool is_over() const { return end_ && Clock::now() >= *end_; }

 private:
  using Clock = std::chrono::steady_clock;

  std::optional<Clock::time_point> end_;
};

}  // namespace meshalyzer
