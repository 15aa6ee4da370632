#pragma once

#include "meshalyzer/repair/fix_defects.h"
#include "meshalyzer/report/boolean_report.h"
#include "meshalyzer/report/text/list_length.h"
#include "report_options.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer::fixer {

/// A parsed command line, with default values for absent options.
struct Options : ReportOptions {
  /// The mesh files, or folders of such, as the user named them.
  std::vector<std::string> paths;
  /// The current mesh file, or "-".
  std::string input;
  enum class Action : std::uint8_t { Find, Fix, Combine };
  Action action = Action::Fix;
  /// The boolean operation, if the inputs are combined.
  BooleanOperation operation = BooleanOperation::Union;
  /// The output: a mesh file, or "-". Absent with --find and --dry-run.
  std::optional<std::string> output;
  /// The destination of meshes: OUT, or files with the name of the input in the folder OUT, or the
  /// inputs themselves.
  enum class Target : std::uint8_t { File, Folder, InPlace };
  Target target = Target::File;
  /// What is kept of overwritten inputs.
  enum class Backup : std::uint8_t { None, Original };
  Backup backup = Backup::None;
  RepairOptions repair;
  /// The time in seconds after which the repair ends with its best result.
  std::optional<double> time_limit;
  /// The action if the output cannot hold attributes of the input.
  enum class Loss : std::uint8_t { Tell, Refuse };
  Loss loss = Loss::Tell;
  ListLength lists = ListLength::Short;
  /// The destination of one line of JSON per file.
  std::optional<ReportTarget> ndjson;
  /// The file of the page.
  std::optional<std::string> html;

  [[nodiscard]] bool is_batch() const { return target != Target::File; }
  [[nodiscard]] bool writes_to_stdout() const { return output == "-"; }
};

/// An Options, or the text for --help or --version.
struct CommandLine {
  Options options;
  /// The text for --help or --version; if present, it is printed and nothing else is done.
  std::optional<std::string> answer;
};

/// Parses a command line without touching any file.
///
/// @throws UsageError if it is wrong.
[[nodiscard]] CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace meshalyzer::fixer
