#pragma once

#include "meshalyzer/repair/fix_defects.h"
#include "meshalyzer/report/boolean_report.h"
#include "meshalyzer/report/text/defects_report.h"
#include "report_options.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer::fixer {

/// A command line, understood. What is not on it is as it is here.
struct Options : ReportOptions {
  /// Mesh files, or folders of such, as they are named.
  std::vector<std::string> paths;
  /// The mesh file in hand, or "-".
  std::string input;
  enum class Action : std::uint8_t { Find, Fix, Combine };
  Action action = Action::Fix;
  /// What becomes of the inputs, where they are combined.
  BooleanOperation operation = BooleanOperation::Union;
  /// A mesh file, or "-". Absent with --find and --dry-run.
  std::optional<std::string> output;
  /// Where meshes go: OUT, or files of the name of the input in the folder OUT, or the inputs
  /// themselves.
  enum class Target : std::uint8_t { File, Folder, InPlace };
  Target target = Target::File;
  /// What is left of inputs that are written over.
  enum class Backup : std::uint8_t { None, Original };
  Backup backup = Backup::None;
  RepairOptions repair;
  /// After so many seconds the repair ends with what it has.
  std::optional<double> time_limit;
  /// What is done where the output cannot hold attributes of the input.
  enum class Loss : std::uint8_t { Tell, Refuse };
  Loss loss = Loss::Tell;
  ListLength lists = ListLength::Short;
  /// A line of JSON a file.
  std::optional<ReportTarget> ndjson;
  /// The file of the page.
  std::optional<std::string> html;

  [[nodiscard]] bool is_batch() const { return target != Target::File; }
  [[nodiscard]] bool writes_to_stdout() const { return output == "-"; }
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
