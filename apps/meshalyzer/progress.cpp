#include "progress.h"

#include "interrupt.h"
#include "progress_text.h"

#include <ostream>

namespace meshalyzer {
namespace {

ProgressLine::State state_of(const Options& options, const std::ostream& err) {
  return options.progress == ReportOptions::Progress::Never ? ProgressLine::State::Off
                                                            : terminal_state(err);
}

}  // namespace

Progress::Progress(const Options& options, Streams streams)
    : out_(streams.out), line_(streams.err, state_of(options, streams.err)) {}

void Progress::on_mesh(Index, const Analysis&) {
  clear();
}

void Progress::on_unreadable(Index, const std::string&) {
  clear();
}

void Progress::on_progress(const RunProgress& progress) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kBetweenShows{100};
  const Clock::time_point now = Clock::now();
  if (progress.stage != last_stage_) {
    last_stage_ = progress.stage;
    stage_begin_ = now;
  }
  is_out_of_order_ = !out_;
  if (now - last_shown_ >= kBetweenShows && progress.total > 1) {
    last_shown_ = now;
    line_.show(progress_text(progress, now - stage_begin_));
  }
}

bool Progress::wants_to_stop() {
  return is_out_of_order_ || InterruptGuard::is_interrupted();
}

}  // namespace meshalyzer
