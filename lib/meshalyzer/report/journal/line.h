#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/json/report.h"
#include "meshalyzer/set/file_stamp.h"
#include "meshalyzer/set/object_findings.h"
#include "meshalyzer/set/request.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The beginning of each line of a journal: the subject of the line, and the state of its file.
struct LineHead {
  enum class Kind : std::uint8_t {
    /// The line has the analysis of a mesh.
    Mesh,
    /// The line has the reason why a file could not be read.
    Unreadable,
    /// The line has the findings between a mesh and the others of its set.
    Between,
  };
  Kind kind = Kind::Mesh;
  /// The number of the mesh in the set, from 0.
  std::size_t number = 0;
  /// The number of files in the set.
  std::size_t of = 0;
  std::string path;
  FileStamp stamp;
  Request request;
  /// A fingerprint of all files of the set.
  std::string set;

  friend bool operator==(const LineHead&, const LineHead&) = default;
};

/// Returns a line of a journal: one JSON object, ended by a line feed. The head's members come
/// first, then those of an element of "meshes" in the report: read_mesh_members() reads these.
/// @param head  The head, whose kind and path are ignored: the path of the analysis is written.
[[nodiscard]] std::string mesh_line(const LineHead& head, const Analysis& analysis,
                                    JsonOffenders offenders);

/// Returns a line with the reason why a file could not be read ("error").
[[nodiscard]] std::string unreadable_line(const LineHead& head, std::string_view why);

/// Returns a line with the findings between a mesh and others: "name", "intersecting_pairs",
/// "contained", "partly_contained" and "closest", with rows as in the report, or null if not
/// requested. "numbers" has the numbers of the meshes that the rows name.
/// @param head   The head, with the number of the owner.
/// @param names  The names of the meshes of the set, by number.
[[nodiscard]] std::string between_line(const LineHead& head, const ObjectFindings& findings,
                                       const std::vector<std::string>& names);

/// Reads only the head of a line, so that a truncated rest is not noticed.
/// @throws InvalidArgument  if it is not the beginning of such a line, or one of another version of
///     meshalyzer, whose findings may differ.
/// @complexity  O(length of the head).
[[nodiscard]] LineHead read_head(std::string_view line);

/// Returns the reason that unreadable_line() has written.
/// @throws InvalidArgument  if it is no such line.
[[nodiscard]] std::string read_unreadable(std::string_view line);

/// Reads what between_line() wrote, all numbers to the last bit. Points that were not found are not
/// written: they are read as 0, as are their faces.
/// @param names  The names of the meshes when the line was written.
/// @throws InvalidArgument  if it is no such line, or one of meshes with other names.
[[nodiscard]] ObjectFindings read_between(std::string_view line,
                                          const std::vector<std::string>& names);

}  // namespace meshalyzer
