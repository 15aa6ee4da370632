#pragma once

#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/writer.h"
#include "meshalyzer/set/object_findings.h"

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {

/// Writes rows of findings between meshes: lists that may be too long for memory.
class FindingsWriter {
 public:
  /// @param names    The names of the meshes, by number. The object only refers to them and to
  ///                 `json`.
  /// @param on_row   Called after each row, when the text so far may be drained.
  FindingsWriter(JsonWriter& json, const std::vector<std::string>& names,
                 std::function<void()> on_row)
      : json_(json), names_(names), on_row_(std::move(on_row)) {}

  /// Writes a list of rows `["a.mesh", f, "b.mesh", g, "kind"]` as a value.
  void pairs(std::span<const SetPair> pairs);
  /// Writes the members for a list of pairs that is cut, "unlisted", and for a search that ended at
  /// its time limit, "at_least".
  void bounds(const SetIntersections& found);
  /// Writes a list of rows `["inner.mesh", "outer.mesh"]` as a value.
  void contained(std::span<const ContainedMesh> meshes);
  /// Writes a list of rows `[vertex, distance, "b.mesh", face, [x, y, z]]` as a value; everything
  /// except the vertex is null if no point was found.
  ///
  /// If a real is not finite, and so null, a sixth element names it: an object as
  /// write_non_finite() makes it.
  void closest(const ObjectSeparation& separation);

 private:
  void name(Index mesh);
  void closest_row(const ObjectSeparation& separation, std::size_t i);
  void end_row();

  JsonWriter& json_;
  const std::vector<std::string>& names_;
  std::function<void()> on_row_;
};

/// Defines "set_pairs", "contained" and "closest", the lists that FindingsWriter writes, and
/// "name", by which they name meshes.
void define_findings(SchemaDefinitions& schema);

}  // namespace meshalyzer
