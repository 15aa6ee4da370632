#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace meshalyzer {

/// The elements that the records of a section name by number, from 1.
enum class InriaNames : std::uint8_t {
  Nothing,
  Vertices,
  Edges,
  Triangles,
  Quadrilaterals,
  Tetrahedra
};

/// A section that does not concern the triangles: a count, then records with a fixed number of
/// numbers.
struct InriaSection {
  std::string_view keyword;
  std::size_t numbers_a_record;
  InriaNames names;
  /// The number of names in a record.
  std::size_t n_names;
  /// The number of other numbers before them.
  std::size_t n_before = 0;
};

inline constexpr std::array<InriaSection, 38> kInriaSections = {{
    {"Edges", 3, InriaNames::Vertices, 2},
    {"EdgesP2", 4, InriaNames::Vertices, 3},
    {"TrianglesP2", 7, InriaNames::Vertices, 6},
    {"Tetrahedra", 5, InriaNames::Vertices, 4},
    {"TetrahedraP2", 11, InriaNames::Vertices, 10},
    {"Hexahedra", 9, InriaNames::Vertices, 8},
    {"Hexaedra", 9, InriaNames::Vertices, 8},
    {"Prisms", 7, InriaNames::Vertices, 6},
    {"Pentahedra", 7, InriaNames::Vertices, 6},
    {"Pyramids", 6, InriaNames::Vertices, 5},
    {"Corners", 1, InriaNames::Vertices, 1},
    {"Ridges", 1, InriaNames::Edges, 1},
    {"RequiredVertices", 1, InriaNames::Vertices, 1},
    {"RequiredEdges", 1, InriaNames::Edges, 1},
    {"RequiredTriangles", 1, InriaNames::Triangles, 1},
    {"RequiredQuadrilaterals", 1, InriaNames::Quadrilaterals, 1},
    {"RequiredTetrahedra", 1, InriaNames::Tetrahedra, 1},
    {"ParallelTriangles", 1, InriaNames::Triangles, 1},
    {"ParallelEdges", 1, InriaNames::Edges, 1},
    {"SharedVertices", 1, InriaNames::Vertices, 1},
    {"Normals", 3, InriaNames::Nothing, 0},
    {"NormalAtVertices", 2, InriaNames::Vertices, 1},
    {"NormalAtTriangleVertices", 3, InriaNames::Triangles, 1},
    {"NormalAtQuadrilateralVertices", 3, InriaNames::Quadrilaterals, 1},
    {"Tangents", 3, InriaNames::Nothing, 0},
    {"TangentAtVertices", 2, InriaNames::Vertices, 1},
    {"TangentAtEdges", 3, InriaNames::Edges, 1},
    {"TangentAtEdgeVertices", 3, InriaNames::Edges, 1},
    {"SubDomain", 4, InriaNames::Triangles, 1, 1},
    {"SubDomainFromMesh", 4, InriaNames::Triangles, 1, 1},
    {"SubDomainFromGeom", 4, InriaNames::Nothing, 0},
    {"VertexOnGeometricVertex", 2, InriaNames::Vertices, 1},
    {"VertexOnGeometricEdge", 3, InriaNames::Vertices, 1},
    {"VertexOnGeometricTriangle", 4, InriaNames::Vertices, 1},
    {"EdgeOnGeometricEdge", 2, InriaNames::Edges, 1},
    {"TriangleOnGeometricTriangle", 2, InriaNames::Triangles, 1},
    {"VertexOnSupportVertex", 2, InriaNames::Vertices, 1},
    {"VertexOnSupportEdge", 3, InriaNames::Vertices, 1},
}};

/// A statement that does not concern the triangles and has no count.
struct InriaStatement {
  std::string_view keyword;
  /// The numbers after the keyword; 0 if the rest of the line is a name.
  std::size_t n_numbers;
};

inline constexpr std::array<InriaStatement, 4> kInriaStatements = {
    {{"AngleOfCornerBound", 1}, {"BoundingBox", 6}, {"Geometry", 0}, {"Identifier", 0}}};

/// Returns the section or statement with a keyword; null if there is none.
[[nodiscard]] constexpr const InriaSection* find_inria_section(std::string_view keyword) {
  const auto* const found =
      std::find_if(kInriaSections.begin(), kInriaSections.end(),
                   [&](const InriaSection& known) { return known.keyword == keyword; });
  return found == kInriaSections.end() ? nullptr : found;
}
[[nodiscard]] constexpr const InriaStatement* find_inria_statement(std::string_view keyword) {
  const auto* const found =
      std::find_if(kInriaStatements.begin(), kInriaStatements.end(),
                   [&](const InriaStatement& known) { return known.keyword == keyword; });
  return found == kInriaStatements.end() ? nullptr : found;
}

}  // namespace meshalyzer
