#include "session.h"

#include "interrupt.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/report/text/mesh_report.h"
#include "meshalyzer/report/text/set_report.h"
#include "meshalyzer/report/text/summary_table.h"
#include "progress_text.h"

#include <ostream>
#include <utility>

namespace meshalyzer {
namespace {

ProgressLine::State progress_state(const Options& options, const std::ostream& err) {
  return options.progress == Options::Progress::Never ? ProgressLine::State::Off
                                                      : terminal_state(err);
}

/// Distances to other meshes come only when all meshes are known.
PictureSubject::Separation waits_for(const Task& task) {
  const bool follows = task.inputs.is_set && questions_of(task.options).separation;
  return follows ? PictureSubject::Separation::Follows : PictureSubject::Separation::Never;
}

}  // namespace

Session::Session(Task task, Streams streams)
    : task_(std::move(task)),
      options_(task_.options),
      inputs_(task_.inputs),
      subject_(task_.subject),
      known_(task_.known),
      streams_(streams),
      progress_(streams.err, progress_state(options_, streams.err)),
      name_width_(summary_width(subject_.names)),
      pictures_({options_, inputs_.files, subject_.names, task_.pictures, waits_for(task_)}) {}

ExitCode Session::work() {
  for (const std::string& trouble : inputs_.troubles) {
    complain(trouble);
  }
  if (options_.json) {
    json_.emplace(*options_.json, subject_.offenders, streams_.out);
  }
  if (tells_text() && options_.show == Show::Summary) {
    streams_.out << summary_header(name_width_);
  }
  const std::optional<SetAnalysis> set = analyze_set(inputs_.files, set_options(), *this);
  progress_.clear();
  const bool is_interrupted = !set && InterruptGuard::is_interrupted();
  if (is_interrupted) {
    tell_interrupted();
  }
  if (set && inputs_.is_set && set->meshes != 0) {
    tell_set(*set);
  }
  // Where the run was stopped there is no whole report to take the place of an old one.
  if (set) {
    const SetAnalysis* told = inputs_.is_set ? &*set : nullptr;
    pictures_.finish(told);
    if (json_) {
      json_->finish(told);
    }
  }
  if (!streams_.out.flush()) {
    complain("meshalyzer: standard output: cannot be written");
  }
  return is_interrupted ? ExitCode::Interrupted
         : trouble_     ? ExitCode::Trouble
         : all_good_    ? ExitCode::Done
                        : ExitCode::NotGood;
}

SetOptions Session::set_options() const {
  SetOptions options;
  options.analysis = options_.analysis;
  options.questions = inputs_.is_set ? questions_of(options_) : SetQuestions{};
  options.questions.statistics = inputs_.is_set && tells_totals(options_);
  options.memory_limit = options_.memory_limit;
  options.shard = options_.shard;
  return options;
}

std::optional<Analysis> Session::known_mesh(Index number) {
  return known_.mesh(number);
}

std::optional<std::string> Session::known_trouble(Index number) {
  return known_.trouble(number);
}

std::optional<ObjectFindings> Session::known_findings(Index owner) {
  std::optional<ObjectFindings> known = known_.findings(owner, subject_);
  if (!known && task_.unknown == Task::Unknown::Refuse) {
    throw IoError(inputs_.files[owner], {},
                  "no line tells what is between this mesh and the others: is a part missing?");
  }
  return known;
}

void Session::on_mesh(Index number, const Analysis& mesh) {
  progress_.clear();
  ++n_files_done_;
  all_good_ = all_good_ && (!mesh.goodness || mesh.goodness->good);
  if (journal_ && !known_.has_file(number)) {
    journal_->append(
        mesh_line(subject_.head(LineHead::Kind::Mesh, number), mesh, subject_.offenders));
  }
  if (json_) {
    json_->report().add(mesh);
  }
  pictures_.on_mesh(number, mesh);
  if (tells_text() && options_.show == Show::Summary) {
    streams_.out << summary_line(subject_.names[number], mesh, name_width_);
  } else if (tells_text() && options_.show == Show::Report) {
    tell(mesh);
  }
}

void Session::tell(const Analysis& mesh) {
  std::ostream& out = streams_.out;
  const bool is_among_others = inputs_.is_set || inputs_.files.size() > 1;
  const bool is_verdict = mesh.goodness && options_.offenders == OffenderStyle::None;
  if (is_among_others && is_verdict) {
    out << mesh.path << ": ";
  } else if (is_among_others) {
    out << (n_told_ == 0 ? "" : "\n") << "==== " << mesh.path << " ====\n";
  }
  out << text_report(mesh, options_.offenders);
  ++n_told_;
}

void Session::on_unreadable(Index number, const std::string& why) {
  ++n_files_done_;
  if (journal_ && !known_.has_file(number)) {
    journal_->append(unreadable_line(subject_.head(LineHead::Kind::Unreadable, number), why));
  }
  if (tells_text() && options_.show == Show::Summary) {
    streams_.out << summary_of_unreadable(subject_.names[number], why, name_width_);
  }
  pictures_.on_unreadable(number, why);
  complain(why);
}

void Session::on_findings(const ObjectFindings& findings) {
  if (journal_ && !known_.has_findings(findings.owner)) {
    journal_->append(between_line(subject_.head(LineHead::Kind::Between, findings.owner), findings,
                                  subject_.names));
  }
  if (json_) {
    json_->report().add(findings, subject_.names);
  }
  pictures_.on_findings(findings);
}

void Session::on_progress(const SetProgress& progress) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kBetweenShows{100};
  const Clock::time_point now = Clock::now();
  if (progress.stage != last_stage_) {
    last_stage_ = progress.stage;
    stage_begin_ = now;
  }
  is_out_of_order_ = !streams_.out;
  if (now - last_shown_ >= kBetweenShows && progress.total > 1) {
    last_shown_ = now;
    progress_.show(progress_text(progress, now - stage_begin_));
  }
}

bool Session::wants_to_stop() {
  return is_out_of_order_ || InterruptGuard::is_interrupted();
}

bool Session::tells_text() const {
  const auto is_stdout = [](const std::optional<ReportTarget>& target) {
    return target && target->is_stdout();
  };
  return !is_stdout(options_.json) && !is_stdout(options_.ndjson);
}

void Session::tell_set(const SetAnalysis& set) {
  if (options_.show == Show::TotalVolume) {
    if (!set.volume.reason.empty()) {
      streams_.err << "meshalyzer: total volume: " << set.volume.reason << '\n';
    }
    streams_.out << (set.volume.value ? shortest(*set.volume.value) : "undefined") << '\n';
  } else if (tells_text()) {
    const std::string text = tells_totals(options_) ? text_report(set, options_.offenders)
                                                    : text_report_between(set, options_.offenders);
    streams_.out << (text.empty() ? "" : "\n") << text;
  }
}

void Session::tell_interrupted() {
  streams_.err << "meshalyzer: interrupted: " << n_files_done_ << " of " << inputs_.files.size()
               << " files are done";
  if (options_.ndjson && !options_.ndjson->is_stdout()) {
    streams_.err << "; --resume " << options_.ndjson->file << " goes on with it";
  }
  streams_.err << '\n';
}

void Session::complain(std::string_view message) {
  progress_.clear();
  streams_.err << message << '\n';
  trouble_ = true;
}

}  // namespace meshalyzer
