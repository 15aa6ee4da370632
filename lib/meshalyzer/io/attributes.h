#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The kinds of information that a mesh file may hold in addition to vertices and triangles.
enum class AttributeKind : std::uint8_t {
  Polygons,
  Normals,
  TextureCoordinates,
  VertexColours,
  FaceColours,
  /// The lack of a colour, of vertices and faces that become white because others have a colour.
  AbsentColours,
  Materials,
  Groups,
  SmoothingGroups,
  References,
  VertexProperties,
  FaceProperties,
  AttributeWords,
  LinesAndPoints,
  OtherRecords,
  OtherStatements,
  Headers,
  Comments,
};

/// The count of a kind of attributes: for numbers the vertices, faces or corners that have them,
/// for materials and groups the names, for others the records.
struct AttributeCount {
  AttributeKind kind = AttributeKind::Comments;
  std::size_t count = 0;
};

/// Returns a count for people: "1 material", "33963 texture coordinates".
[[nodiscard]] std::string attribute_text(const AttributeCount& count);

/// Returns the name of a kind in the keys of JSON: "texture_coordinates".
[[nodiscard]] std::string_view attribute_key(AttributeKind kind);

/// Adds up the counts of each kind; the result has the counts that are not zero, ascending by kind.
[[nodiscard]] std::vector<AttributeCount> summed(std::vector<AttributeCount> counts);

}  // namespace meshalyzer
