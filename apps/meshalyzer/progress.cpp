#include "progress.h"

#include "interrupt.h"
#include "meshalyzer/set/run_listener.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ostream>
#include <string>

namespace meshalyzer {
namespace {

constexpr std::size_t kBarWidth = 20;

std::string bar(double share) {
  const auto full = static_cast<std::size_t>(share * kBarWidth);
  std::string text = "[";
  text.append(full, '#').append(kBarWidth - full, ' ').append("]");
  return text;
}

/// Returns a count with three digits and a unit: 12.3 M.
std::string short_count(double count) {
  const char* unit = "";
  for (const char* next : {" k", " M", " G"}) {
    if (count < 1000.0) {
      break;
    }
    count /= 1000.0;
    unit = next;
  }
  char text[32];
  std::snprintf(text, sizeof text, count < 10.0 && *unit != '\0' ? "%.1f%s" : "%.0f%s", count,
                unit);
  return text;
}

std::string clock(double seconds) {
  const auto whole = static_cast<long>(std::min(seconds, 359'999.0));
  char text[32];
  std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
  return text;
}

/// Returns a line that shows the progress of a run: a bar, files, faces, rate and the remaining
/// time, in at most 79 columns.
///
/// @param elapsed  The time since the stage began.
std::string progress_text(const RunProgress& progress, std::chrono::duration<double> elapsed) {
  const double share = progress.total == 0 ? 1.0
                                           : static_cast<double>(progress.done) /
                                                 static_cast<double>(progress.total);
  const auto faces = static_cast<double>(progress.faces);
  std::string text = bar(share) + " ";
  text += progress.stage == RunProgress::Stage::Files ? "files " : "between ";
  text += std::to_string(progress.done) + "/" + std::to_string(progress.total) + ", " +
          short_count(faces) + " faces";
  if (progress.done != 0 && elapsed.count() > 0.0) {
    text += ", " + short_count(faces / elapsed.count()) + "/s, " +
            clock(elapsed.count() * (1.0 - share) / share) + " left";
  }
  return text;
}

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
