#include "stop_request.h"

#include <algorithm>

namespace meshalyzer::fixer {

StopRequest::StopRequest(std::optional<double> time_limit) {
  if (!time_limit) return;
  // A century is as good as no limit, and no clock overflows.
  constexpr double kLongest = 3e9;
  deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double>(std::min(*time_limit, kLongest)));
}

bool StopRequest::is_made() const {
  return InterruptGuard::is_interrupted() || (deadline_ && Clock::now() >= *deadline_);
}

std::string StopRequest::note() {
  return InterruptGuard::is_interrupted()
             ? "the repair was interrupted: more might have been repaired"
             : "the repair ended at its time limit: more might have been repaired";
}

}  // namespace meshalyzer::fixer
