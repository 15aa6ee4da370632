#pragma once

#include "meshalyzer/io/rewrite/corner_blender.h"
#include "meshalyzer/io/rewrite/ply_records.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace meshalyzer {

/// The face records of a PLY file.
struct PlyFaces {
  const PlyElement& element;
  /// The number of the element, and of the property that lists the corners.
  std::size_t number;
  std::size_t corners;
};

/// The lists of faces with two numbers for each corner: texture coordinates.
class PlyCornerLists {
 public:
  /// All arguments must outlive the object.
  PlyCornerLists(const EditedMesh& mesh, const PlyRecords& records, const PlyFaces& faces,
                 const FaceRecords& face_records);

  /// Tells whether a property of a face record is such a list.
  [[nodiscard]] bool has_list(const PlyRecord& record, std::size_t property) const;

  /// Returns the blend that gives a corner of a face its numbers: see CornerBlender.
  [[nodiscard]] Blend blend(FanCorner corner) { return blender_.blend(corner); }

  /// Returns the numbers of a blend of corners in the encoding of the file.
  [[nodiscard]] std::array<std::string, 2> numbers(const Blend& blend, std::size_t property) const;

 private:
  /// Returns the two numbers of a corner of the source, or nothing if its record has none.
  [[nodiscard]] std::optional<std::array<std::string_view, 2>> items_of(Index corner,
                                                                        std::size_t property) const;
  [[nodiscard]] bool has_same_numbers(Index a, Index b) const;

  const PlyRecords& records_;
  PlyFaces faces_;
  const FaceRecords& face_records_;
  CornerBlender blender_;
};

}  // namespace meshalyzer
