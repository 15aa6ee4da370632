#pragma once

#include "meshalyzer/repair/holes/internal/existing_edges.h"

#include <array>
#include <vector>

namespace meshalyzer {

/// A hole loop as triangulations see it: corners with positions, and the faces beyond the edges.
struct LoopPolygon {
  /// File vertices; one that ends a bridge appears more than once.
  std::vector<Index> vertices = {};
  /// The positions, scaled by a power of two so that squares neither overflow nor vanish.
  std::vector<Vec3> points = {};
  /// The unit normal of the face beyond each edge, from corner i to the next; zero if there is
  /// none, or none with an area.
  std::vector<Vec3> normals = {};
  /// An altitude below this makes a triangle thin. Scaled like the points.
  double thin = 0.0;

  [[nodiscard]] std::size_t size() const { return vertices.size(); }
};

/// @param degeneracy  The altitude below which a facet is flat, in the mesh's unit.
[[nodiscard]] LoopPolygon make_polygon(const PreparedMesh& mesh, const HoleLoop& loop,
                                       double degeneracy);

/// The criterion that makes one triangulation of a loop better than another.
enum class LoopWeight : std::uint8_t {
  /// The sharpest bend between neighbouring faces, then the area.
  BendThenArea,
  Area,
  /// The overlap of triangles as seen along the axis that shows the loop best, then short edges. It
  /// is not minimised over all triangulations, but corner by corner (see triangulate_large_loop()).
  Flat,
};

/// The edges and triangles that a triangulation may use.
struct LoopRules {
  const ExistingEdges* existing = nullptr;
  /// Edges that joining loops has added: they are in the patch already.
  std::vector<std::array<Index, 2>> bridges = {};
  /// Triangles that were tried and intersected something: their vertices ascending, and the list
  /// too.
  std::vector<Triangle> forbidden = {};
  LoopWeight weight = LoopWeight::BendThenArea;

  /// Tells whether the patch may have an inner edge between two vertices.
  [[nodiscard]] bool allows_chord(Index a, Index b) const;
  /// Tells whether the patch may have a triangle, by its corners and the forbidden triangles.
  [[nodiscard]] bool allows_triangle(const Triangle& corners) const;
  void forbid(std::vector<Triangle> triangles);
};

/// The fault of a triangle, from none to the worst.
enum class TriangleFault : std::uint8_t { None, Thin, Collinear };

/// A candidate triangle, measured.
struct CandidateTriangle {
  TriangleFault fault = TriangleFault::None;
  /// The unit normal; zero if the triangle has none.
  Vec3 normal = Vec3::Zero();
  /// The area, and a tiny share for the length of the edges, which decides between equal areas.
  double cost = 0.0;
};

/// @param thin  The altitude as LoopPolygon::thin has it.
[[nodiscard]] CandidateTriangle measure_candidate(const Vec3& a, const Vec3& b, const Vec3& c,
                                                  double thin);

/// Returns how sharply two faces are bent at their common edge, from 0, about flat, to 1, folded
/// back. The result has a few steps, so that other criteria decide between nearly equal bends. It
/// is 0 if a normal is zero.
[[nodiscard]] double bend_between(const Vec3& normal_a, const Vec3& normal_b);

}  // namespace meshalyzer
