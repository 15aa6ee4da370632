#pragma once

#include "meshalyzer/io/attributes.h"
#include "meshalyzer/io/obj_corner.h"
#include "meshalyzer/io/rewrite/face_plan.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// A statement other than a face that names vertices: a line, points, or a free-form element.
struct ObjNaming {
  std::size_t begin = 0;
  /// The number of words before the first vertex: the keyword and the parameters.
  std::size_t n_before = 1;
  AttributeKind kind = AttributeKind::LinesAndPoints;
  /// The statements between a curve or surface and its `end`, which belong to it.
  std::vector<std::size_t> body;
};

/// The offsets of the statements of an OBJ file, by kind, in the order of the file.
struct ObjRecords {
  std::vector<std::size_t> vertices;
  std::vector<std::size_t> texture_points;
  std::vector<std::size_t> normals;
  std::vector<std::size_t> faces;
  std::vector<ObjNaming> naming;
  /// The statements `con`, which name surfaces by number.
  std::vector<std::size_t> connections;
  FaceRecords face_records;
  /// Tells whether any face counts backwards from the last record.
  bool has_relative_faces = false;

  /// Returns the numbers of records of each kind before a statement.
  [[nodiscard]] ObjCounts counts_before(std::size_t statement) const;
};

/// Finds the statements of a text that parse_obj() reads.
///
/// @complexity O(bytes) time.
[[nodiscard]] ObjRecords find_obj_records(std::string_view text);

}  // namespace meshalyzer
