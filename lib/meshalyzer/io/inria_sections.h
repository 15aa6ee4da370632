#pragma once

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

}  // namespace meshalyzer
