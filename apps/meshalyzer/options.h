#pragma once

#include "meshalyzer/base/colour_map.h"
#include "meshalyzer/base/memory_size.h"
#include "meshalyzer/picture/field.h"
#include "meshalyzer/report/text/mesh_report.h"
#include "meshalyzer/set/request.h"
#include "meshalyzer/set/shard.h"
#include "report_options.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// The questions about a set. If neither is named, both are asked about a folder, but none with -a
/// or -g.
struct NamedQuestions {
  bool intersections = false;
  bool separation = false;

  [[nodiscard]] bool any() const { return intersections || separation; }
};

/// A field of each mesh, written to a file.
struct FieldExport {
  /// The file for the field of one mesh. For several meshes its name without the ending is a
  /// folder, with one file for each mesh.
  std::optional<std::string> file;
  /// The field; present if the file is.
  std::optional<FieldName> field;
  /// The palette; by default the one that suits the field.
  std::optional<Palette> palette;
};

/// A parsed command line, with default values for absent options.
struct Options : ReportOptions {
  /// The mesh files, folders, or "-"; at least one. For the command merge, the journals.
  std::vector<std::string> paths;
  MeshRequest mesh;
  /// The time limit in seconds.
  std::optional<double> time_limit;
  NamedQuestions questions;
  SeparationOptions separation;
  /// Measures the separation even if a mesh is not good (--force).
  bool force = false;
  OffenderStyle offenders = OffenderStyle::None;
  /// Prints only the total volume of a folder to standard output (-v).
  bool total_volume = false;
  /// Prints one line for each mesh in place of its report.
  bool summary = false;
  std::optional<ReportTarget> ndjson;
  /// The journal of an earlier run to resume.
  std::optional<std::string> resume;
  /// The folder for one PLY file per object, coloured by its separation.
  std::optional<std::string> separation_ply;
  FieldExport field_export;
  /// The file of the page of one mesh, or of the index of several.
  std::optional<std::string> html;
  std::optional<Shard> shard;
  /// The memory limit in bytes.
  std::uint64_t memory_limit = physical_memory() / 2;

  /// Tells whether reports on a mesh show positions, for which its file is needed.
  [[nodiscard]] bool shows_places() const {
    return offenders == OffenderStyle::CustomPoints || html || field_export.file;
  }
};

/// An Options, or the text for --help or --version.
struct CommandLine {
  Options options;
  /// The text for --help or --version; if present, it is printed and nothing else is done.
  std::optional<std::string> answer;
};

/// Parses a command line without touching any file.
///
/// @throws UsageError if it is wrong: an unknown option, a bad number, no path, or options that
/// exclude each other.
[[nodiscard]] CommandLine parse_command_line(int argc, const char* const* argv);

/// Parses the command line of `meshalyzer merge`.
/// @param argv  The arguments from the word `merge` on.
[[nodiscard]] CommandLine parse_merge_command_line(int argc, const char* const* argv);

}  // namespace meshalyzer
