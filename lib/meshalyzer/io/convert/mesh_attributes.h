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

/// What a file says of a mesh beside positions, triangles and normals, as far as several formats
/// can say it.
struct MeshAttributes {
  /// Tells which triangles are one polygon.
  FaceRecords faces;
  /// Colours by vertex, and by face record; empty where none has one.
  std::vector<std::optional<Rgba>> vertex_colours;
  std::vector<std::optional<Rgba>> face_colours;
  /// Texture points by corner, see first_corner(); empty where none has one.
  std::vector<std::optional<TexturePoint>> texture;
  /// Tells how many of the file's texture coordinates these are.
  std::size_t n_texture_points = 0;
  /// The solids of an STL file that have a name.
  std::vector<Group> solids;
  /// References by vertex, and by face record, in INRIA's format; empty where all are 0.
  std::vector<std::int32_t> vertex_references;
  std::vector<std::int32_t> face_references;
  /// The attribute words of a binary STL file, by face; empty where all are 0.
  std::vector<std::uint16_t> attribute_words;
  /// What comments before the first record say, with the blank before it; of a binary STL file what
  /// its header says, where that is text.
  std::vector<std::string> comments;
};

/// Returns the place of a record's first corner among those of all records, of which each has at
/// least three.
[[nodiscard]] inline std::size_t first_corner(const FaceRecords& faces, Index record) {
  return faces.first_triangle[record] + 2 * std::size_t{record};
}

/// Returns the vertices at the corners of a record, in the order of the file; those of a record of
/// fewer than three corners are those of its triangle.
[[nodiscard]] std::vector<Index> corners_of(const FaceRecords& faces, const Soup& soup,
                                            Index record);

/// Gives each corner the texture coordinates of its vertex.
void use_at_corners(MeshAttributes& attributes, const Soup& soup,
                    const std::vector<TexturePoint>& points);

/// Records of one triangle each.
[[nodiscard]] FaceRecords single_triangles(std::size_t n);

}  // namespace meshalyzer
