#include "run.h"

#include "interrupt.h"
#include "meshalyzer/base/control_characters.h"
#include "meshalyzer/report/set_verdict.h"
#include "meshalyzer/set/analyze_files.h"
#include "meshalyzer/set/set_run.h"
#include "outputs.h"
#include "pictures.h"
#include "progress.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Determines the exit status of a run, and reports errors as they happen.
class Outcome : public RunListener {
 public:
  Outcome(const Options& options, std::ostream& err) : options_(options), err_(err) {}

  void on_mesh(Index number, const Analysis& mesh) override;
  void on_unreadable(Index number, const std::string& why) override;
  void on_no_separation(const std::string& why) override;
  void report_error(const std::string& message);
  /// Takes the verdict on a set, which may be not good although all its meshes are.
  void on_verdict(const Goodness& set);

  [[nodiscard]] std::size_t n_files_done() const { return n_files_done_; }
  [[nodiscard]] ExitCode exit_code() const;

 private:
  const Options& options_;
  std::ostream& err_;
  std::size_t n_files_done_ = 0;
  bool all_good_ = true;
  bool failed_ = false;
};

void Outcome::on_mesh(Index, const Analysis& mesh) {
  ++n_files_done_;
  all_good_ = all_good_ && (!mesh.goodness || mesh.goodness->good);
}

void Outcome::on_unreadable(Index, const std::string& why) {
  ++n_files_done_;
  report_error(why);
}

/// Reports the options whose files are not written.
void Outcome::on_no_separation(const std::string& why) {
  const std::string message = " has written nothing: " + without_controls(why);
  if (options_.separation_ply) {
    report_error("meshalyzer: --separation-ply" + message);
  }
  if (options_.field_export.field == FieldName::Separation) {
    report_error("meshalyzer: --field separation" + message);
  }
}

void Outcome::on_verdict(const Goodness& set) {
  all_good_ = all_good_ && set.good;
}

void Outcome::report_error(const std::string& message) {
  err_ << message << '\n';
  failed_ = true;
}

ExitCode Outcome::exit_code() const {
  return failed_ ? ExitCode::Failure : all_good_ ? ExitCode::Done : ExitCode::NotGood;
}

/// Forwards all findings to several listeners, one after the other.
class Listeners : public RunListener {
 public:
  void add(RunListener& listener) { listeners_.push_back(&listener); }

  void on_mesh(Index number, const Analysis& mesh) override {
    for (RunListener* listener : listeners_) listener->on_mesh(number, mesh);
  }
  void on_unreadable(Index number, const std::string& why) override {
    for (RunListener* listener : listeners_) listener->on_unreadable(number, why);
  }
  void on_findings(const ObjectFindings& findings) override {
    for (RunListener* listener : listeners_) listener->on_findings(findings);
  }
  void on_no_separation(const std::string& why) override {
    for (RunListener* listener : listeners_) listener->on_no_separation(why);
  }
  void on_progress(const RunProgress& progress) override {
    for (RunListener* listener : listeners_) listener->on_progress(progress);
  }
  [[nodiscard]] bool wants_to_stop() override {
    return std::any_of(listeners_.begin(), listeners_.end(),
                       [](RunListener* listener) { return listener->wants_to_stop(); });
  }

 private:
  std::vector<RunListener*> listeners_;
};

/// The results of the files.
struct Findings {
  /// False if the run was stopped, or is only one shard.
  bool is_whole = false;
  std::optional<SetAnalysis> set;
};

Findings analyze(const Run& run, RunListener& listener) {
  const Options& options = run.options;
  const SetOptions how{.request = run.request,
                       .keep_soup = options.shows_places(),
                       .keep_mesh = draws_at_once(run),
                       .memory_limit = options.memory_limit,
                       .shard = options.shard.value_or(Shard{}),
                       .earlier = run.earlier};
  if (!run.request.is_set) {
    return {analyze_files(run.inputs.files, how, listener), std::nullopt};
  }
  std::optional<SetAnalysis> set = analyze_set(run.inputs.files, how, listener);
  return {set.has_value(), std::move(set)};
}

void report_interruption(const Run& run, const Outcome& outcome, std::ostream& err) {
  err << "meshalyzer: interrupted: " << outcome.n_files_done() << " of " << run.inputs.files.size()
      << " files are done";
  if (run.options.ndjson && !run.options.ndjson->is_stdout()) {
    err << "; --resume " << run.options.ndjson->file << " goes on with it";
  }
  err << '\n';
}

}  // namespace

ExitCode carry_out(const Run& run, Streams streams) {
  Outcome outcome(run.options, streams.err);
  for (const std::string& error : run.inputs.errors) {
    outcome.report_error(error);
  }
  Progress progress(run.options, streams);
  const std::vector<std::unique_ptr<Output>> outputs = outputs_of(run, streams);
  Listeners listeners;
  listeners.add(progress);
  if (run.journal != nullptr) {
    listeners.add(*run.journal);
  }
  for (const std::unique_ptr<Output>& output : outputs) {
    listeners.add(*output);
  }
  listeners.add(outcome);
  const Findings found = analyze(run, listeners);
  progress.clear();
  const std::optional<Goodness> verdict = found.set ? set_verdict(*found.set) : std::nullopt;
  if (verdict && run.request.mesh.goodness) {
    outcome.on_verdict(*verdict);
  }
  const bool is_interrupted = !found.is_whole && InterruptGuard::is_interrupted();
  if (is_interrupted) {
    report_interruption(run, outcome, streams.err);
  }
  if (found.is_whole) {
    // The output for a person comes first.
    std::for_each(outputs.rbegin(), outputs.rend(),
                  [&](const auto& output) { output->finish(found.set ? &*found.set : nullptr); });
  }
  if (!streams.out.flush()) {
    outcome.report_error("meshalyzer: standard output: cannot be written");
  }
  return is_interrupted ? ExitCode::Interrupted : outcome.exit_code();
}

}  // namespace meshalyzer
