#pragma once

#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/report/text.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// The command line does not say something that can be done. what() is for the user.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// Where the JSON report goes: "-" is standard output, in place of the text.
struct JsonTarget {
  std::string file = "-";

  [[nodiscard]] bool is_stdout() const { return file == "-"; }
};

/// What goes to standard output.
enum class Show {
  /// The report of each mesh, and of a folder the totals.
  Report,
  /// Only the total volume of a folder (-v).
  TotalVolume,
};

/// A command line, understood.
struct Options {
  /// Mesh files, folders, or "-"; at least one.
  std::vector<std::string> paths;
  AnalysisOptions analysis;
  OffenderStyle offenders = OffenderStyle::None;
  Show show = Show::Report;
  std::optional<JsonTarget> json;
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

/// Understands a command line (contract 3). Touches no file.
///
/// @throws UsageError if it is wrong: an unknown option, a bad number, no path, or options that
/// exclude each other.
[[nodiscard]] CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace meshalyzer
