#include "check/run_check.h"

#include "check/jobs.h"
#include "interrupt.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/checks/known_findings.h"
#include "meshalyzer/checks/mesh_files.h"
#include "meshalyzer/report/check/baseline.h"
#include "usage_error.h"

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <map>
#include <unistd.h>

namespace meshalyzer {
namespace {

/// https://no-color.org: set to anything but nothing, it forbids colours.
bool is_colour_forbidden() {
  const char* no_colour = std::getenv("NO_COLOR");
  return no_colour != nullptr && *no_colour != '\0';
}

TextColour colour_of(ColourChoice choice, const std::ostream& out) {
  const bool on_terminal = &out == &std::cout && ::isatty(STDOUT_FILENO) == 1;
  const bool wanted = choice == ColourChoice::Always ||
                      (choice == ColourChoice::OnTerminal && on_terminal && !is_colour_forbidden());
  return wanted ? TextColour::Always : TextColour::Never;
}

/// Takes what is known out of what is found: the files then list all their findings first.
class Baseline {
 public:
  explicit Baseline(const CheckCommand& command) {
    if (command.baseline) known_.emplace(read_baseline(*command.baseline));
  }

  void prepare(std::vector<CheckJob>& jobs) {
    if (!known_) return;
    for (CheckJob& job : jobs) {
      max_listed_[job.name] = job.criteria.max_listed;
      job.criteria.max_listed = 0;
    }
  }

  [[nodiscard]] FileFindings new_findings(FileFindings file) {
    if (!known_) return file;
    known_->drop_from(file);
    cut_listed(file, max_listed_[file.path]);
    return file;
  }

 private:
  std::optional<KnownFindings> known_;
  std::map<std::string, std::size_t> max_listed_;
};

ExitCode exit_code_of(const CheckTotals& totals, bool has_trouble) {
  return has_trouble || totals.unreadable != 0 ? ExitCode::Trouble
         : totals.not_good != 0                ? ExitCode::NotGood
                                               : ExitCode::Done;
}

ExitCode check_all(const CheckCommand& command, Streams streams) {
  const auto begin = std::chrono::steady_clock::now();
  const MeshFiles found = find_mesh_files(command.paths, command.excluded);
  for (const std::string& trouble : found.troubles) streams.err << trouble << '\n';
  std::vector<CheckJob> jobs = jobs_of(command, found.files);
  Baseline baseline(command);
  baseline.prepare(jobs);
  const std::unique_ptr<CheckReport> report = make_check_report(
      command.format, [&](std::string_view text) { streams.out << text; },
      colour_of(command.colour, streams.out));
  CheckTotals totals;
  const auto tell = [&](const FileFindings& file) {
    const FileFindings told = baseline.new_findings(file);
    report->add(told);
    totals.add(told);
    return streams.out.flush() && !InterruptGuard::is_interrupted();
  };
  if (!check_files(jobs, command.memory_limit, tell) && InterruptGuard::is_interrupted()) {
    streams.err << "meshalyzer: interrupted: " << totals.meshes << " of " << jobs.size()
                << " files are done\n";
    return ExitCode::Interrupted;
  }
  report->finish(totals, std::chrono::steady_clock::now() - begin);
  if (!streams.out.flush()) {
    streams.err << "meshalyzer: standard output: cannot be written\n";
    return ExitCode::Trouble;
  }
  return exit_code_of(totals, !found.troubles.empty());
}

/// Prints findings, each with what became of it before it.
void print_findings(std::string_view what, const FileFindings& file, std::ostream& out) {
  const auto sink = [&](std::string_view line) { out << what << line; };
  make_check_report(CheckFormat::Text, sink)->add(file);
}

/// Returns those of the findings of a mesh that another one has not.
FileFindings findings_beside(FileFindings file, const FileFindings& other) {
  std::vector<KnownFinding> known = known_of(other);
  for (KnownFinding& finding : known) finding.path = file.path;
  KnownFindings(known).drop_from(file);
  return file;
}

std::size_t n_findings(const FileFindings& file) {
  return file.findings.size() + (file.is_readable() ? 0 : 1);
}

ExitCode compare_meshes(const CheckCommand& command, Streams streams) {
  std::vector<CheckJob> jobs = jobs_of(command, command.paths);
  for (CheckJob& job : jobs) job.criteria.max_listed = 0;
  std::vector<FileFindings> files;
  static_cast<void>(check_files(jobs, command.memory_limit, [&](const FileFindings& file) {
    files.push_back(file);
    return true;
  }));
  if (files.size() != 2) throw UsageError("check: --diff: a settings file excludes a mesh");
  const FileFindings gone = findings_beside(files[0], files[1]);
  const FileFindings added = findings_beside(files[1], files[0]);
  print_findings("gone: ", gone, streams.out);
  print_findings("new: ", added, streams.out);
  streams.out << n_findings(gone) << " gone, " << n_findings(added) << " new, "
              << n_findings(files[1]) - n_findings(added) << " as before\n";
  const bool is_readable = files[0].is_readable() && files[1].is_readable();
  return !is_readable             ? ExitCode::Trouble
         : n_findings(added) != 0 ? ExitCode::NotGood
                                  : ExitCode::Done;
}

}  // namespace

ExitCode run_check(const CheckCommand& command, Streams streams) {
  const ThreadLimit limit(command.threads);
  const InterruptGuard guard;
  return command.is_comparison ? compare_meshes(command, streams) : check_all(command, streams);
}

}  // namespace meshalyzer
