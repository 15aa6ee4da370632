#pragma once

#include "meshalyzer/repair/fix_defects.h"
#include "meshalyzer/report/text/defects_report.h"
#include "report_options.h"

#include <cstdint>
#include <optional>
#include <string>

namespace meshalyzer::fixer {

/// A command line, understood. What is not on it is as it is here.
struct Options : ReportOptions {
  /// A mesh file, or "-".
  std::string input;
  enum class Action : std::uint8_t { Find, Fix };
  Action action = Action::Fix;
  /// Absent with --find and --dry-run.
  std::optional<std::string> output;
  RepairOptions repair;
  /// After so many seconds the repair ends with what it has.
  std::optional<double> time_limit;
  ListLength lists = ListLength::Short;
  /// The file of the page.
  std::optional<std::string> html;
};

/// An Options, or the text that --help or --version asks for.
struct CommandLine {
  Options options;
  /// The answer to --help or --version; where it is present, it is printed and nothing else is
  /// done.
  std::optional<std::string> answer;
};

/// Understands a command line. Touches no file.
///
/// @throws UsageError if it is wrong.
[[nodiscard]] CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace meshalyzer::fixer
