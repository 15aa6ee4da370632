#pragma once

#include "meshalyzer/set/run_listener.h"
#include "options.h"
#include "progress_line.h"
#include "streams.h"

#include <atomic>
#include <chrono>
#include <optional>

namespace meshalyzer {

/// Shows the progress of a run, and stops it if the user interrupts it or standard output fails.
class Progress : public RunListener {
 public:
  Progress(const Options& options, Streams streams);

  void on_mesh(Index number, const Analysis& mesh) override;
  void on_unreadable(Index number, const std::string& why) override;
  void on_progress(const RunProgress& progress) override;
  [[nodiscard]] bool wants_to_stop() override;
  /// Removes the line from the terminal.
  void clear() { line_.clear(); }

 private:
  std::ostream& out_;
  ProgressLine line_;
  std::optional<RunProgress::Stage> last_stage_;
  std::chrono::steady_clock::time_point stage_begin_;
  std::chrono::steady_clock::time_point last_shown_;
  std::atomic<bool> is_out_of_order_ = false;
};

}  // namespace meshalyzer
