#pragma once

#include <array>
#include <vector>

/// Exercise 1: link a half-edge structure by hand. See 1_half_edge.md.
namespace lab {

/// "No such element": the face of a half-edge on the border, the half-edge of an unused vertex.
inline constexpr int kNone = -1;

/// A side of a face, or of the hole beside a border. All members are indices.
struct HalfEdge {
  /// Where it starts.
  int vertex = kNone;
  /// The face on its left; kNone on the border.
  int face = kNone;
  /// The half-edges after and before it round the same face, or round the same hole.
  int next = kNone;
  int prev = kNone;
  /// The half-edge of the same edge in the other direction.
  int pair = kNone;
};

struct HalfEdgeMesh {
  /// Half-edges 3 f, 3 f + 1 and 3 f + 2 are the sides of face f; those of the border come after.
  std::vector<HalfEdge> halfedges;
  /// For each vertex one half-edge that starts there; kNone where no face uses it.
  std::vector<int> vertex_halfedge;
};

/// Exercise 1 a: the three half-edges of each face, linked into an inner loop by next and prev.
///
/// Half-edge 3 f + k starts at corner k of face f. No half-edge has a pair yet.
///
/// @param n_vertices  There may be more than the faces use.
/// @param faces       The vertices of each, counter-clockwise seen from outside.
HalfEdgeMesh link_faces(int n_vertices, const std::vector<std::array<int, 3>>& faces);

/// Exercise 1 b: finds the pair of each half-edge that has one.
///
/// @throws std::invalid_argument where two half-edges run between the same vertices in the same
/// direction: the faces are not a consistently oriented manifold there.
void link_pairs(HalfEdgeMesh& mesh);

/// Exercise 1 c: gives each half-edge without a pair one that has no face, and links these into
/// loops round the holes. Afterwards every half-edge has next, prev and pair.
///
/// No vertex is on more than one hole.
void link_borders(HalfEdgeMesh& mesh);

}  // namespace lab
