#pragma once

#include "meshalyzer/io/rewrite/corner_blender.h"
#include "meshalyzer/io/rewrite/obj_records.h"

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace meshalyzer {

/// The texture coordinates and normals that the corners of an edited OBJ file name: those of the
/// source, followed by new ones.
class ObjAttributes {
 public:
  ObjAttributes(const EditedMesh& mesh, std::string_view text, const ObjRecords& records);

  /// Returns the records that a corner of a rewritten face names.
  [[nodiscard]] ObjCorner corner(FanCorner corner);
  /// Returns the normal of a corner.
  /// @param named  The record that this corner named in the source, or kNoIndex.
  [[nodiscard]] Index normal(FanCorner corner, Index named);

  /// Returns the values of the new texture points, each to follow its keyword.
  [[nodiscard]] const std::vector<std::string>& new_texture_points() const {
    return texture_points_.values;
  }
  [[nodiscard]] const std::vector<std::string>& new_normals() const { return normals_.values; }

 private:
  /// The new records of one kind, each value once.
  struct NewRecords {
    std::vector<std::string> values;
    std::unordered_map<std::string, Index> numbers;
    [[nodiscard]] Index insert(std::string value);
  };

  [[nodiscard]] const std::vector<ObjCorner>& source_corners(Index record);
  /// Returns the records that a corner of the source names, by its number.
  [[nodiscard]] ObjCorner source_corner(Index number);
  [[nodiscard]] Index texture_point(const Blend& blend);
  /// Returns the coordinates of a texture point of the source.
  [[nodiscard]] const std::vector<double>& texture_numbers(Index texture_point);

  const EditedMesh& mesh_;
  std::string_view text_;
  const ObjRecords& records_;
  /// Tells whether there is no texture point and no normal that a corner could name.
  bool has_none_;
  CornerBlender blender_;
  NewRecords texture_points_;
  NewRecords normals_;
  /// The coordinates of the texture points that were asked for: pieces of a cut face ask for the
  /// same ones again and again.
  std::unordered_map<Index, std::vector<double>> texture_numbers_;
  /// The record whose corners were parsed last.
  Index latest_record_ = kNoIndex;
  std::vector<ObjCorner> latest_corners_;
};

}  // namespace meshalyzer
