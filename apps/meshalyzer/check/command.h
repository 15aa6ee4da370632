#pragma once

#include "meshalyzer/base/memory_size.h"
#include "meshalyzer/checks/settings.h"
#include "meshalyzer/io/gzip.h"
#include "meshalyzer/report/check/check_report.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// Tells when a report has colours.
enum class ColourChoice : std::uint8_t { OnTerminal, Always, Never };

/// The parsed command line of `meshalyzer check`, with default values for absent options.
struct CheckCommand {
  /// The mesh files, folders, or "-"; at least one.
  std::vector<std::string> paths;
  /// The patterns of paths to skip in folders.
  std::vector<std::string> excluded;
  /// The name of standard input in reports.
  std::optional<std::string> stdin_name;
  CheckSettings settings;
  /// The settings file; by default the nearest one to each mesh file.
  std::optional<std::string> settings_file;
  /// Tells whether settings files are ignored.
  bool is_isolated = false;
  /// The JSON report of an earlier check, whose findings are accepted.
  std::optional<std::string> baseline;
  /// Tells whether two meshes are compared.
  bool is_comparison = false;
  CheckFormat format = CheckFormat::Text;
  ColourChoice colour = ColourChoice::OnTerminal;
  /// The number of threads; 0 means as many as the machine has cores.
  std::size_t threads = 0;
  /// The largest allowed ratio of the unpacked size of a gzipped file to its size.
  std::uint64_t max_unpack_ratio = kDefaultUnpackRatio;
  /// The memory limit in bytes.
  std::uint64_t memory_limit = physical_memory() / 2;
};

/// A CheckCommand, or the text for --help.
struct CheckCommandLine {
  CheckCommand command;
  /// The text for --help; if present, it is printed and nothing else is done.
  std::optional<std::string> answer;
};

/// Parses a command line without touching any file.
///
/// @param argv  The arguments from the word `check` on.
/// @throws UsageError if it is wrong.
[[nodiscard]] CheckCommandLine parse_check_command_line(int argc, const char* const* argv);

}  // namespace meshalyzer
