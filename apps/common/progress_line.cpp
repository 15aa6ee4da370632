#include "progress_line.h"

#include "terminal.h"

#include <ostream>

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
  return is_terminal(stream) ? ProgressLine::State::On : ProgressLine::State::Off;
}

}  // namespace meshalyzer
