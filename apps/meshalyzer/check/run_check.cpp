#include "check/run_check.h"

#include "check/command.h"
#include "interrupt.h"
#include "mesh_paths.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/checks/check_files.h"
#include "meshalyzer/checks/known_findings.h"
#include "meshalyzer/checks/mesh_files.h"
#include "meshalyzer/checks/settings.h"
#include "meshalyzer/report/check/baseline.h"
#include "terminal.h"
#include "usage_error.h"

#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

/// Finds the settings for files, and reads each settings file once.
class SettingsFiles {
 public:
  explicit SettingsFiles(const CheckCommand& command) : command_(command) {}

  /// Returns the settings for a mesh file, or null if there are none.
  const SettingsFile* of(const std::string& mesh) {
    if (command_.is_isolated) return nullptr;
    const std::string path =
        command_.settings_file ? *command_.settings_file : find_settings_file(mesh);
    if (path.empty()) return nullptr;
    const auto [known, is_new] = files_.try_emplace(path);
    if (is_new) known->second = read_settings_file(path);
    return &known->second;
  }

 private:
  const CheckCommand& command_;
  std::map<std::string, SettingsFile> files_;
};

/// Returns the files to check, each with the criteria of its settings file and of the command line;
/// files that a settings file excludes are skipped.
///
/// @throws IoError  if a settings file is wrong.
std::vector<CheckJob> jobs_of(const CheckCommand& command, const std::vector<std::string>& files) {
  SettingsFiles settings(command);
  std::vector<CheckJob> jobs;
  for (const std::string& file : files) {
    const std::string name = file == "-" ? command.stdin_name.value_or("-") : file;
    const SettingsFile* from_file = settings.of(name);
    if (from_file != nullptr && is_excluded(*from_file, name)) continue;
    jobs.push_back({file, name, criteria_for(name, from_file, command.settings)});
  }
  return jobs;
}

/// Tells whether NO_COLOR is set and not empty, which forbids colours (https://no-color.org).
bool is_colour_forbidden() {
  const char* no_colour = std::getenv("NO_COLOR");
  return no_colour != nullptr && *no_colour != '\0';
}

TextColour colour_of(ColourChoice choice, const std::ostream& out) {
  const bool wanted =
      choice == ColourChoice::Always ||
      (choice == ColourChoice::OnTerminal && is_terminal(out) && !is_colour_forbidden());
  return wanted ? TextColour::Always : TextColour::Never;
}

/// Removes the known findings from those found. Until then the files must list all their findings.
class Baseline {
 public:
  explicit Baseline(const CheckCommand& command) {
    if (command.baseline) known_.emplace(read_baseline(*command.baseline));
  }

  void prepare(std::vector<CheckJob>& jobs) {
    if (!known_) return;
    for (CheckJob& job : jobs) {
      criteria_[job.name] = job.criteria;
      job.criteria.max_listed = 0;
    }
  }

  [[nodiscard]] FileFindings new_findings(FileFindings file) {
    if (!known_) return file;
    known_->drop_from(file);
    const CheckCriteria& criteria = criteria_[file.path];
    cut_listed(file, criteria.max_listed, criteria.max_lines);
    return file;
  }

 private:
  std::optional<KnownFindings> known_;
  /// The criteria of each file, which limit what is reported of it.
  std::map<std::string, CheckCriteria> criteria_;
};

ExitCode exit_code_of(const CheckTotals& totals, bool has_errors) {
  return has_errors || totals.unreadable != 0 ? ExitCode::Failure
         : totals.not_good != 0               ? ExitCode::NotGood
                                              : ExitCode::Done;
}

/// Says that there is nothing to check because all mesh files are excluded, by --exclude or by a
/// settings file.
void tell_all_excluded(std::size_t n_excluded, std::ostream& err) {
  err << "meshalyzer check: "
      << (n_excluded == 1 ? "the only mesh file is excluded"
                          : "all " + std::to_string(n_excluded) + " mesh files are excluded")
      << '\n';
}

ExitCode check_all(const CheckCommand& command, Streams streams) {
  const auto begin = std::chrono::steady_clock::now();
  const MeshFiles found = find_mesh_files(command.paths, command.excluded);
  for (const std::string& error : found.errors) streams.err << error << '\n';
  std::vector<CheckJob> jobs = jobs_of(command, found.files);
  const std::size_t n_excluded = found.n_excluded + found.files.size() - jobs.size();
  if (jobs.empty() && n_excluded != 0) tell_all_excluded(n_excluded, streams.err);
  Baseline baseline(command);
  baseline.prepare(jobs);
  const std::unique_ptr<CheckReport> report = make_check_report(
      command.format, [&](std::string_view text) { streams.out << text; },
      colour_of(command.colour, streams.out));
  CheckTotals totals;
  const auto on_file = [&](const FileFindings& file) {
    const FileFindings reported = baseline.new_findings(file);
    report->add(reported);
    totals.add(reported);
    return streams.out.flush() && !InterruptGuard::is_interrupted();
  };
  if (!check_files(jobs, command.memory_limit, on_file) && InterruptGuard::is_interrupted()) {
    streams.err << "meshalyzer: interrupted: " << totals.meshes << " of " << jobs.size()
                << " files are done\n";
    return ExitCode::Interrupted;
  }
  report->finish(totals, std::chrono::steady_clock::now() - begin);
  if (!streams.out.flush()) {
    streams.err << "meshalyzer: standard output: cannot be written\n";
    return ExitCode::Failure;
  }
  return exit_code_of(totals, !found.errors.empty());
}

/// Prints findings, each with a word for its change before it.
void print_findings(std::string_view what, const FileFindings& file, std::ostream& out) {
  const auto sink = [&](std::string_view line) { out << what << line; };
  make_check_report(CheckFormat::Text, sink)->add(file);
}

/// Returns the findings of a mesh that another mesh does not have.
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
  for (const std::string& path : command.paths) {
    if (is_folder(path)) {
      throw UsageError("--diff needs two mesh files, and " + path + " is a folder");
    }
  }
  std::vector<CheckJob> jobs = jobs_of(command, command.paths);
  for (CheckJob& job : jobs) job.criteria.max_listed = 0;
  std::vector<FileFindings> files;
  static_cast<void>(check_files(jobs, command.memory_limit, [&](const FileFindings& file) {
    files.push_back(file);
    return true;
  }));
  if (files.size() != 2) throw UsageError("--diff: a settings file excludes a mesh");
  const FileFindings gone = findings_beside(files[0], files[1]);
  const FileFindings added = findings_beside(files[1], files[0]);
  print_findings("gone: ", gone, streams.out);
  print_findings("new: ", added, streams.out);
  streams.out << n_findings(gone) << " gone, " << n_findings(added) << " new, "
              << n_findings(files[1]) - n_findings(added) << " as before\n";
  const bool is_readable = files[0].is_readable() && files[1].is_readable();
  return !is_readable             ? ExitCode::Failure
         : n_findings(added) != 0 ? ExitCode::NotGood
                                  : ExitCode::Done;
}

}  // namespace

ExitCode run_check(const CheckCommand& command, Streams streams) {
  const ThreadLimit limit(command.threads);
  const UnpackLimit unpack_limit(command.max_unpack_ratio);
  const InterruptGuard guard;
  return command.is_comparison ? compare_meshes(command, streams) : check_all(command, streams);
}

}  // namespace meshalyzer
