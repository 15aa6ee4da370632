#pragma once

#include "meshalyzer/repair/fix_defects.h"
#include "meshalyzer/report/text/defects_report.h"
#include "report_target.h"

#include <cstddef>
#include <optional>
#include <string>

namespace meshalyzer::fixer {

/// A command line, understood.
struct Options {
  /// A mesh file, or "-".
  std::string input;
  enum class Action { Find, Fix };
  Action action = Action::Fix;
  /// Absent with --find and --dry-run.
  std::optional<std::string> output;
  RepairOptions repair;
  ListLength lists = ListLength::Short;
  std::optional<ReportTarget> json;
  /// The file of the page.
  std::optional<std::string> html;
  /// 0: as many as the machine has cores.
  std::size_t threads = 0;
  enum class Progress { OnTerminal, Never };
  Progress progress = Progress::OnTerminal;
};

/// An Options, or the text that --help or --version asks for.
struct CommandLine {
  Options options;
  /// Where present: print this and do nothing else.
  std::optional<std::string> answer;
};

/// Understands a command line (contract 6). Touches no file.
///
/// @throws UsageError if it is wrong.
[[nodiscard]] CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace meshalyzer::fixer
