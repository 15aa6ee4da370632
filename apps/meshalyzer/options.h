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

/// The questions about a set: where neither is named, a folder is asked for both, but for nothing
/// with -a or -g.
struct AskedOfSet {
  bool intersections = false;
  bool separation = false;

  [[nodiscard]] bool any() const { return intersections || separation; }
};

/// A field of each mesh, written to a file.
struct FieldExport {
  /// The file to write the picture of one mesh to. Where there are several meshes, its name without
  /// the ending is a folder, with a file a mesh.
  std::optional<std::string> file;
  /// There where a file is.
  std::optional<FieldName> field;
  /// The palette; where it is absent, the one that suits the field.
  std::optional<Palette> palette;
};

/// A command line, understood. What is not on it is as it is here.
struct Options : ReportOptions {
  /// Mesh files, folders, or "-"; at least one. The journals, where the command is merge.
  std::vector<std::string> paths;
  MeshRequest mesh;
  /// In seconds.
  std::optional<double> time_limit;
  AskedOfSet asked;
  SeparationOptions separation;
  /// --force
  bool force = false;
  OffenderStyle offenders = OffenderStyle::None;
  /// Prints nothing but the total volume of a folder to standard output (-v).
  bool total_volume = false;
  /// A line a mesh in place of its report.
  bool summary = false;
  std::optional<ReportTarget> ndjson;
  /// The journal of an earlier run to go on with.
  std::optional<std::string> resume;
  /// A folder for a PLY an object, coloured by its separation.
  std::optional<std::string> separation_ply;
  FieldExport field_export;
  /// The file of the page of one mesh, or of the index of several.
  std::optional<std::string> html;
  std::optional<Shard> shard;
  /// Bytes.
  std::uint64_t memory_limit = physical_memory() / 2;

  /// Tells whether what is told of a mesh shows places, for which its file is needed.
  [[nodiscard]] bool shows_places() const {
    return offenders == OffenderStyle::CustomPoints || html || field_export.file;
  }
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
/// @throws UsageError if it is wrong: an unknown option, a bad number, no path, or options that
/// exclude each other.
[[nodiscard]] CommandLine parse_command_line(int argc, const char* const* argv);

/// Understands that of `meshalyzer merge`.
/// @param argv  From the word `merge` on.
[[nodiscard]] CommandLine parse_merge_command_line(int argc, const char* const* argv);

}  // namespace meshalyzer
