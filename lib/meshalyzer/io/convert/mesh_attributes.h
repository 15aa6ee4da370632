#pragma once

#include "meshalyzer/io/rewrite/face_plan.h"
#include "meshalyzer/mesh/soup.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// Red, green, blue and opacity, each from 0 to 1.
using Rgba = std::array<double, 4>;
using TexturePoint = std::array<double, 2>;

/// The attributes of a mesh, other than positions, triangles and normals, that several formats can
/// hold.
struct MeshAttributes {
  /// The records of the faces, which tell which triangles form one polygon.
  FaceRecords faces;
  /// The colours of the vertices, and of the face records; empty if none has one.
  std::vector<std::optional<Rgba>> vertex_colours;
  std::vector<std::optional<Rgba>> face_colours;
  /// The texture points of the corners, see first_corner(); empty if none has one.
  std::vector<std::optional<TexturePoint>> texture;
  /// The number of texture coordinates in the file that these represent.
  std::size_t n_texture_points = 0;
  /// The solids of an STL file that have a name.
  std::vector<Group> solids;
  /// The references of the vertices, and of the face records, in INRIA's format; empty if all are
  /// 0.
  std::vector<std::int32_t> vertex_references;
  std::vector<std::int32_t> face_references;
  /// The attribute words of the faces of a binary STL file; empty if all are 0.
  std::vector<std::uint16_t> attribute_words;
  /// The comments before the first record, with their leading blanks; for a binary STL file its
  /// header, if that is text.
  std::vector<std::string> comments;
};

/// Returns the position of a record's first corner among those of all records, each of which has at
/// least three.
[[nodiscard]] inline std::size_t first_corner(const FaceRecords& faces, Index record) {
  return faces.first_triangle[record] + 2 * std::size_t{record};
}

/// Returns the vertices at the corners of a record, in the order of the file; for a record with
/// fewer than three corners, those of its triangle.
[[nodiscard]] std::vector<Index> corners_of(const FaceRecords& faces, const Soup& soup,
                                            Index record);

/// Gives each corner the texture coordinates of its vertex.
void use_at_corners(MeshAttributes& attributes, const Soup& soup,
                    const std::vector<TexturePoint>& points);

/// Returns records of one triangle each.
[[nodiscard]] FaceRecords single_triangles(std::size_t n);

}  // namespace meshalyzer
