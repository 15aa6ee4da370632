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

/// When a report has colours.
enum class ColourChoice : std::uint8_t { OnTerminal, Always, Never };

/// The command line of `meshalyzer check`, understood. What is not on it is as it is here.
struct CheckCommand {
  /// Mesh files, folders, or "-"; at least one.
  std::vector<std::string> paths;
  /// Patterns of what is left out in folders.
  std::vector<std::string> excluded;
  /// What standard input is called.
  std::optional<std::string> stdin_name;
  CheckSettings settings;
  /// The settings file; by default the one that is nearest to each mesh file.
  std::optional<std::string> settings_file;
  /// Settings files are left alone.
  bool is_isolated = false;
  /// The JSON report of an earlier check, whose findings are accepted.
  std::optional<std::string> baseline;
  /// Two meshes are compared.
  bool is_comparison = false;
  CheckFormat format = CheckFormat::Text;
  ColourChoice colour = ColourChoice::OnTerminal;
  /// 0: as many as the machine has cores.
  std::size_t threads = 0;
  /// Tells how many times its size a gzipped file may take.
  std::uint64_t max_unpack_ratio = kDefaultUnpackRatio;
  /// Bytes.
  std::uint64_t memory_limit = physical_memory() / 2;
};

/// A CheckCommand, or the text that --help asks for.
struct CheckCommandLine {
  CheckCommand command;
  /// Where present: print this and do nothing else.
  std::optional<std::string> answer;
};

/// Understands a command line. Touches no file.
///
/// @param argv  From the word `check` on.
/// @throws UsageError if it is wrong.
[[nodiscard]] CheckCommandLine parse_check_command_line(int argc, const char* const* argv);

}  // namespace meshalyzer
