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

/// The beginning of each line of a journal: the subject of the line, and the state of the file of
/// which it is true.
struct LineHead {
  enum class Kind : std::uint8_t {
    /// The line tells what is known about a mesh.
    Mesh,
    /// Why a file could not be read.
    Unreadable,
    /// The line tells what was found between a mesh and the others of its set.
    Between,
  };
  Kind kind = Kind::Mesh;
  /// The number of the mesh in the set, from 0.
  std::size_t number = 0;
  /// Files in the set.
  std::size_t of = 0;
  std::string path;
  FileStamp stamp;
  Request asked;
  /// A fingerprint of all files of the set.
  std::string set;

  friend bool operator==(const LineHead&, const LineHead&) = default;
};

/// Returns a line of a journal: one JSON object, ended by a line feed. The head's members come
/// first, then those of an element of "meshes" in the report: read_mesh_json() reads these.
/// @param head  Its kind does not matter, nor does its path: that of the analysis is written.
[[nodiscard]] std::string mesh_line(const LineHead& head, const Analysis& analysis,
                                    JsonOffenders offenders);

/// Returns a line that tells why a file could not be read ("error").
[[nodiscard]] std::string unreadable_line(const LineHead& head, std::string_view why);

/// Returns a line with what a mesh has to do with others: "name", "intersecting_pairs",
/// "contained", "partly_contained" and "closest", rows as in the report; null where not asked for.
/// "numbers" tells the numbers of the meshes that the rows name.
/// @param head   Its number is that of the owner.
/// @param names  Of the meshes of the set, by number.
[[nodiscard]] std::string between_line(const LineHead& head, const ObjectFindings& findings,
                                       const std::vector<std::string>& names);

/// Reads the head of a line, and no more of it than that: a line that was cut off later is not
/// noticed.
/// @throws InvalidArgument  Not the beginning of such a line, or one of another version of
/// meshalyzer, which may find otherwise.
/// @complexity  O(length of the head).
[[nodiscard]] LineHead read_head(std::string_view line);

/// Returns the trouble that unreadable_line() was told.
/// @throws InvalidArgument  Not such a line.
[[nodiscard]] std::string read_trouble(std::string_view line);

/// Reads what between_line() wrote, all numbers to the last bit. Points where nothing was found are
/// not written: they are read as 0, as are their faces.
/// @param names  As they were when the line was written.
/// @throws InvalidArgument  Not such a line, or one of meshes with other names.
[[nodiscard]] ObjectFindings read_between(std::string_view line,
                                          const std::vector<std::string>& names);

}  // namespace meshalyzer
