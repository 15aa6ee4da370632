#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/mesh/soup.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

/// The definitions, evaluated on a soup word by word: slow, simple, and without any half-edges.
namespace meshalyzer::direct {

/// Two vertices, the smaller first.
using Edge = std::pair<Index, Index>;

/// The faces that count, and the faces at each edge.
struct Complex {
  std::vector<Triangle> triangles;
  std::map<Edge, std::vector<std::size_t>> faces_at;
};

[[nodiscard]] Complex complex_of(const Soup& soup);

/// Edges with this many faces.
[[nodiscard]] std::set<Edge> edges_with(const Complex& complex, std::size_t n_faces);

/// A number for each face, the same where faces share a vertex, directly or through others: 0, 1,
/// ... by first appearance.
[[nodiscard]] std::vector<Index> components(const Complex& complex);

/// Does the same as components() for faces that share an edge.
[[nodiscard]] std::vector<Index> edge_components(const Complex& complex);

/// The border edges, put together where they belong to the same boundary.
[[nodiscard]] std::set<std::set<Edge>> boundaries(const Complex& complex);

/// Vertices on no edge of more than two faces, whose faces do not all hang together through
/// two-face edges at the vertex.
[[nodiscard]] std::vector<Index> pinched_vertices(const Complex& complex);

/// Tells whether some choice of faces to turn makes all two-face edges consistent, where only the
/// edges of faces of this edge component count. Tries all choices: for a few faces only.
[[nodiscard]] bool is_orientable(const Complex& complex, Index edge_component);

/// A few faces on a few vertices at random, some of them degenerate. The seed decides.
[[nodiscard]] Soup random_soup(std::uint32_t seed, std::size_t n_faces);

/// The two file vertices of a half-edge, the smaller first.
[[nodiscard]] Edge edge_of(const CutMesh& cut, HalfedgeHandle halfedge);

}  // namespace meshalyzer::direct
