#pragma once

#include "meshalyzer/base/types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The format that a file was read as.
enum class Format { Mesh, Inria, Obj, Off, Stl, Ply };

/// Returns the lower-case name that reports use: "mesh", "inria", "obj", "off", "stl", "ply".
[[nodiscard]] std::string_view format_name(Format format);

/// The file's ids of its vertices or faces, by record.
///
/// Formats that number their records implicitly (all but `.mesh`) need no list: the id of record i
/// is first + i.
struct Ids {
  std::int32_t first = 1;
  /// One id for each record if the file names them, else empty.
  std::vector<std::int32_t> named;

  [[nodiscard]] std::int64_t of(Index record) const {
    return named.empty() ? std::int64_t{first} + record : named[record];
  }
};

/// A corner of a face that names a vertex which no record defines.
struct MissingReference {
  Index face = 0;
  /// The number of the corner in the triangle: 0, 1 or 2.
  std::uint8_t corner = 0;
  /// The id that the file names.
  std::int64_t id = 0;
};

/// A named run of faces (OBJ `g` or `o`).
struct Group {
  std::string name;
  /// The first face of the run; the run ends where the next group begins, or with the last face.
  Index first_face = 0;
};

/// The faithful content of a mesh file: every record in file order, nothing cleaned, merged,
/// reordered or dropped.
///
/// STL is the one exception: it names no vertices, so its bit-identical points become one vertex,
/// numbered by first appearance (0.0 and -0.0 are the same place); n_merged_points tells how many
/// were merged.
///
/// A program may make a soup of its own, or change one that was read: ids, lines, groups and
/// normals of corners are then to be changed with the records, or cleared. All functions refuse a
/// soup that contradicts itself, as where a record has no id and others have one, with
/// InvalidArgument.
struct Soup {
  Format format = Format::Mesh;
  /// #V positions, one for each vertex record; all finite.
  std::vector<Vec3> positions;
  /// #F triangles as indices into `positions`; kNoIndex at a corner whose vertex no record defines.
  /// A polygon of k corners stands here as k - 2 triangles (fanned from its first corner); a
  /// "polygon" of two corners a, b as the degenerate triangle a b b, of one corner as a a a. Where
  /// several records define one id, the first counts.
  std::vector<Triangle> triangles;
  Ids vertex_ids;
  Ids face_ids;
  /// The references in face order, then corner order.
  std::vector<MissingReference> missing;
  /// The 1-based line of each record if the file is text and read by lines, else empty.
  std::vector<std::uint32_t> vertex_lines;
  std::vector<std::uint32_t> face_lines;
  /// Only in `.mesh`: the 1-based lines that begin with a number instead of Vertex or Face. They
  /// are remains of torn records and hold no record.
  std::vector<std::uint32_t> torn_lines;
  /// The groups in file order; empty where the file has none. Faces before the first group belong
  /// to none.
  std::vector<Group> groups;
  /// Normals that the file gives, in file order; empty where none.
  std::vector<Vec3> normals;
  /// #F, indices into `normals` of each corner (kNoIndex: none); empty where the file gives no
  /// normals.
  std::vector<Triangle> corner_normals;
  /// Only in STL: the number of corners whose point had occurred before.
  std::size_t n_merged_points = 0;
  /// The number of face records with more than three corners, each fanned into triangles.
  std::size_t n_polygons = 0;

  [[nodiscard]] std::size_t n_vertices() const { return positions.size(); }
  [[nodiscard]] std::size_t n_faces() const { return triangles.size(); }
};

/// Returns the positions of the corners of a face, in the order of the file; all of them must be
/// defined.
[[nodiscard]] std::array<Vec3, 3> corners_of(const Soup& soup, Index face);

/// Tells whether the corners of two faces of the complex are at the same three positions.
[[nodiscard]] bool have_equal_corners(const Soup& soup, Index a, Index b);

/// Returns triangles as a mesh of their own: in their order, with the vertices that they use alone,
/// numbered by first use. All corners must be defined.
///
/// @complexity O(#V + #F).
[[nodiscard]] Soup compact_soup(const std::vector<Vec3>& positions,
                                std::vector<Triangle> triangles);

/// Returns the index of the group that a face belongs to, or kNoIndex if it belongs to none.
///
/// @complexity O(log #groups).
[[nodiscard]] Index group_of(const Soup& soup, Index face);

/// Tells whether a face names all three vertices, all defined, all different: only such faces are
/// in the complex.
[[nodiscard]] constexpr bool is_in_complex(const Triangle& t) {
  return t[0] != kNoIndex && t[1] != kNoIndex && t[2] != kNoIndex && t[0] != t[1] && t[1] != t[2] &&
         t[2] != t[0];
}

}  // namespace meshalyzer
