#pragma once

#include "meshalyzer/base/colour_map.h"
#include "meshalyzer/picture/field.h"
#include "meshalyzer/report/json/report.h"
#include "meshalyzer/report/text/mesh_report.h"
#include "meshalyzer/set/set_options.h"
#include "report_target.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// What goes to standard output.
enum class Show {
  /// The report of each mesh, and of a set what there is to say of it.
  Report,
  /// A line a mesh, and of a set what there is to say of it (--summary).
  Summary,
  /// Only the total volume of a folder (-v).
  TotalVolume,
};

/// What is asked about a set: where neither is named, a folder is asked for both, but for nothing
/// with -a or -g.
struct AskedOfSet {
  bool intersections = false;
  bool separation = false;

  [[nodiscard]] bool any() const { return intersections || separation; }
};

/// A field of each mesh, written to a file.
struct FieldExport {
  /// Of one mesh; else FILE without its ending is a folder, with a file a mesh.
  std::string file;
  FieldName field = FieldName::Gaussian;
  /// Where absent: the one that suits the field.
  std::optional<Palette> palette = std::nullopt;
};

/// A command line, understood.
struct Options {
  /// Mesh files, folders, or "-"; at least one.
  std::vector<std::string> paths;
  AnalysisOptions analysis;
  AskedOfSet asked;
  SeparationOptions separation;
  /// --force
  bool force = false;
  OffenderStyle offenders = OffenderStyle::None;
  Show show = Show::Report;
  std::optional<ReportTarget> json;
  std::optional<ReportTarget> ndjson;
  /// The journal of an earlier run to go on with.
  std::optional<std::string> resume;
  /// A folder for a PLY an object, coloured by its separation.
  std::optional<std::string> separation_ply;
  std::optional<FieldExport> field_export;
  /// The file of the page of one mesh, or of the index of several.
  std::optional<std::string> html;
  Shard shard;
  /// Bytes.
  std::uint64_t memory_limit = 0;
  /// 0: as many as the machine has cores.
  std::size_t threads = 0;
  enum class Progress { OnTerminal, Never };
  Progress progress = Progress::OnTerminal;
  /// The options that decide what is found, in a fixed order and spelling; parse_command_line() of
  /// these words, and a path, gives the same findings.
  std::string asked_text;
};

/// An Options, or the text that --help or --version asks for.
struct CommandLine {
  Options options;
  /// Where present: print this and do nothing else.
  std::optional<std::string> answer;
};

/// What to find out between the meshes of a set.
[[nodiscard]] SetQuestions questions_of(const Options& options);

/// Whether there is anything to say of a set beside what lies between its meshes: with -a and -g
/// there is not.
[[nodiscard]] bool tells_totals(const Options& options);

/// Whether reports for programs list the offending elements.
[[nodiscard]] JsonOffenders json_offenders(const Options& options);

/// Understands a command line (contract 3). Touches no file.
///
/// @throws UsageError if it is wrong: an unknown option, a bad number, no path, or options that
/// exclude each other.
[[nodiscard]] CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace meshalyzer
