#include "progress_line.h"

#include <iostream>
#include <unistd.h>

namespace meshalyzer {
namespace {

constexpr std::string_view kEraseLine = "\r\x1b[K";

}  // namespace

void ProgressLine::show(std::string_view message) {
  if (state_ == State::On) {
    terminal_ << kEraseLine << message << std::flush;
    shown_ = true;
  }
}

void ProgressLine::clear() {
  if (shown_) {
    terminal_ << kEraseLine << std::flush;
    shown_ = false;
  }
}

ProgressLine::State terminal_state(const std::ostream& stream) {
  const bool is_terminal = &stream == &std::cerr && isatty(STDERR_FILENO) == 1;
  return is_terminal ? ProgressLine::State::On : ProgressLine::State::Off;
}

}  // namespace meshalyzer
