#include "check/command.h"

#include "arguments.h"
#include "meshalyzer/base/nearest_name.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/checks/limits.h"
#include "meshalyzer/checks/profile.h"
#include "meshalyzer/checks/selection.h"
#include "option_table.h"
#include "report_options.h"
#include "values.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

// The parsers for the values of the options of `check`. All throw UsageError if a text is no valid
// value.

std::string to_profile_name(const std::string& text, const std::string& option) {
  if (const std::string why = why_no_profile(text); !why.empty()) {
    throw UsageError(option + ": " + why);
  }
  return text;
}

CheckFormat to_check_format(const std::string& text, const std::string& option) {
  const std::optional<CheckFormat> format = check_format(text);
  if (!format) {
    std::vector<std::string_view> names;
    for (const CheckFormat each : all_check_formats()) names.push_back(check_format_name(each));
    throw UsageError(option + " needs one of " + names_of(all_check_formats(), check_format_name) +
                     ", not '" + text + "'" + did_you_mean(text, names));
  }
  return *format;
}

ColourChoice to_colour_choice(const std::string& text, const std::string& option) {
  if (text == "always") return ColourChoice::Always;
  if (text == "never") return ColourChoice::Never;
  if (text != "auto") refuse_value(option, "auto, always or never", text);
  return ColourChoice::OnTerminal;
}

/// Returns a function that appends the value to a list.
OptionTable::Take append_to(std::vector<std::string>& list) {
  return [&list](const std::string& text, const std::string&) { list.push_back(text); };
}

/// Returns a function that appends the codes "a,b,c" to a list; each must exist.
OptionTable::Take append_codes(std::vector<std::string>& list) {
  return [&list](const std::string& text, const std::string& option) {
    std::istringstream codes(text);
    for (std::string code; std::getline(codes, code, ',');) {
      if (const std::string why = why_no_check_code(code); !why.empty()) {
        throw UsageError(option + ": " + why);
      }
      list.push_back(code);
    }
  };
}

std::string profile_help() {
  std::string text = "the requirements on the meshes:";
  for (const CheckProfile& profile : check_profiles()) {
    text.append("\n").append(profile.name).append(": ").append(profile.description);
  }
  return text + "\nThe first is the default.";
}

void declare_files(OptionTable& table, CheckCommand& command) {
  table.group("Files");
  table.repeatable(
      "--exclude GLOB", append_to(command.excluded),
      "leave out what fits in folders: a name (*_old.stl), a folder (old/), or a path within the "
      "folder (scans/*.ply); once for each GLOB");
  table.option("--stdin-filename NAME", into(command.stdin_name),
               "the name of standard input (-); its ending determines the format");
}

void declare_criteria(OptionTable& table, CheckCommand& command) {
  CheckSettings& settings = command.settings;
  table.group("Criteria");
  table.option("--profile NAME", into(settings.profile, to_profile_name), profile_help());
  table.repeatable("--select CODES", append_codes(settings.selected),
                   "look for these defects and limits only: a,b,c, or all; see doc/defects.md");
  table.repeatable("--ignore CODES", append_codes(settings.ignored), "leave out these");
  for (const LimitInfo& info : limit_table()) {
    std::string help = info.sense == LimitSense::AtLeast ? "at least N: " : "at most N: ";
    table.option(std::string("--").append(info.name).append(" N"),
                 into(settings.limits[info.kind], to_real), help.append(info.help));
  }
  table.option("--config FILE", into(command.settings_file),
               "take settings from FILE, not from the .meshalyzer.toml that is nearest to each "
               "file, in its folder or in one above; see doc/check.md");
  table.option("--baseline FILE", into(command.baseline),
               "accept the findings in FILE, made by --format json --max 0: they are recognised "
               "by place and code, and only new ones are reported");
  table.flag("--isolated", command.is_isolated, "take no settings from files");
}

void declare_telling(OptionTable& table, CheckCommand& command) {
  table.group("Reports");
  table.flag("--diff", command.is_comparison,
             "compare two meshes: report the findings of the first that the second does not "
             "have, and the new ones of the second; exit status 1 where there is a new one");
  table.option("--format NAME", into(command.format, to_check_format),
               names_of(all_check_formats(), check_format_name));
  table.option(
      "--max N", into(command.settings.max_listed, to_count),
      "list N findings of a code and mesh; 0 lists all. By default 5 at most, and fewer where a "
      "mesh would have 30 lines or more");
  table.option("--color WHEN", into(command.colour, to_colour_choice),
               "auto (on a terminal, unless NO_COLOR is set), always or never");
  table.option("--threads N", into(command.threads, to_thread_count),
               "use at most N threads (all cores)");
  table.option("--memory-limit SIZE", into(command.memory_limit, to_bytes),
               "stay below it (500M, 4G) where the largest few meshes allow it");
  declare_unpack_ratio(table, command.max_unpack_ratio);
}

void check_paths(const CheckCommand& command) {
  if (command.paths.empty()) {
    throw UsageError("no PATH: name mesh files, folders, or - for standard input");
  }
  const auto n_stdin = std::count(command.paths.begin(), command.paths.end(), "-");
  if (n_stdin > 1) {
    throw UsageError("standard input (-) can be read only once");
  }
  if (command.stdin_name && n_stdin == 0) {
    throw UsageError("--stdin-filename needs - among the PATHs");
  }
  if (command.is_comparison && (command.paths.size() != 2 || n_stdin != 0)) {
    throw UsageError("--diff needs two mesh files");
  }
}

bool contains(const std::vector<std::string>& codes, std::string_view code) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

std::string option_of(const LimitInfo& limit) {
  return "--" + std::string(limit.name);
}

/// Rejects criteria of the command line that contradict each other.
void check_criteria(const CheckSettings& settings) {
  for (const std::string& code : settings.selected) {
    if (contains(settings.ignored, code)) {
      throw UsageError("--select and --ignore both name " + code);
    }
  }
  for (const LimitInfo& limit : limit_table()) {
    if (settings.limits[limit.kind] && contains(settings.ignored, limit.name)) {
      throw UsageError(option_of(limit) + " and --ignore " + std::string(limit.name) +
                       " exclude each other");
    }
  }
  constexpr std::pair<LimitKind, LimitKind> kRanges[] = {
      {LimitKind::MinEdgeAngle, LimitKind::MaxEdgeAngle},
      {LimitKind::MinEdgeLength, LimitKind::MaxEdgeLength},
      {LimitKind::MinFaces, LimitKind::MaxFaces}};
  for (const auto& [low, high] : kRanges) {
    const std::optional<double> least = settings.limits[low];
    const std::optional<double> most = settings.limits[high];
    if (least && most && *least > *most) {
      throw UsageError(option_of(limit_info(low)) + " is above " + option_of(limit_info(high)) +
                       ": no mesh meets both");
    }
  }
}

void check_command(const CheckCommand& command) {
  check_paths(command);
  check_criteria(command.settings);
  if (command.settings_file && command.is_isolated) {
    throw UsageError("--config and --isolated exclude each other");
  }
  if (command.is_comparison && (command.baseline || command.format != CheckFormat::Text)) {
    throw UsageError("--diff compares as text: --baseline and --format cannot go with it");
  }
}

}  // namespace

CheckCommandLine parse_check_command_line(int argc, const char* const* argv) {
  CheckCommandLine line;
  CheckCommand& command = line.command;
  OptionTable table(
      {.calls = {"meshalyzer check [options] PATH..."},
       .purpose = "Judges every mesh on its own and tells what is wrong with it, one finding a "
                  "line, the worst first.",
       .footer = "Examples:\n"
                 "meshalyzer check models\n"
                 "meshalyzer check --profile print --max 0 part.stl\n"
                 "meshalyzer check --format sarif models > findings.sarif\n\n"
                 "Exit status: 0 all are good; 1 not all; 2 wrong usage; 3 something could not be "
                 "read; 130 interrupted.",
       .version = ""});
  table.arguments(
      "PATH", command.paths,
      "a mesh file (.mesh .obj .off .stl .ply, also .gz), - for standard input, or a folder: "
      "all mesh files in it and in the folders within it.");
  declare_files(table, command);
  declare_criteria(table, command);
  declare_telling(table, command);
  line.answer = table.parse(argc, argv);
  if (!line.answer) check_command(command);
  return line;
}

}  // namespace meshalyzer
