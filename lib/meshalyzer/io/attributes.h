#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// What a mesh file may say beside vertices and triangles.
enum class AttributeKind : std::uint8_t {
  Polygons,
  Normals,
  TextureCoordinates,
  VertexColours,
  FaceColours,
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

/// Tells how many of a kind there are: of numbers how many vertices, faces or corners have them; of
/// materials and groups how many names; of others how many records.
struct AttributeCount {
  AttributeKind kind = AttributeKind::Comments;
  std::size_t count = 0;
};

/// What a person calls so many of a kind: "1 material", "33963 texture coordinates".
[[nodiscard]] std::string attribute_text(const AttributeCount& count);

/// Returns the name of a kind in the keys of JSON: "texture_coordinates".
[[nodiscard]] std::string_view attribute_key(AttributeKind kind);

/// Returns the counts of a list that are not zero, ascending by kind, each kind once.
[[nodiscard]] std::vector<AttributeCount> summed(std::vector<AttributeCount> counts);

}  // namespace meshalyzer
