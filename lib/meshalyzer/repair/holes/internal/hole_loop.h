#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/pass.h"

#include <vector>

namespace meshalyzer {

/// A closed walk along border edges, in the direction of the edges of a patch: against the faces
/// beyond.
struct HoleLoop {
  /// File vertices; edge i runs from vertex i to the next, the last one back to the first. A loop
  /// made of several by bridges names the ends of bridges more than once.
  std::vector<Index> vertices;
  /// Indexed by edge: the half-edge of the face beyond, which runs against it; not valid for a
  /// bridge.
  std::vector<HalfedgeHandle> halfedges;

  [[nodiscard]] std::size_t size() const { return vertices.size(); }
  [[nodiscard]] Index next(std::size_t edge) const {
    return vertices[edge + 1 < vertices.size() ? edge + 1 : 0];
  }
};

/// The loops of a mesh, and those border chains that form none.
struct HoleLoops {
  std::vector<HoleLoop> loops;
  std::vector<Refusal> refused;
};

/// Finds the loops of border edges that their edges allow to be filled: they close, have one
/// direction all round, and have at least three edges.
///
/// @return  The loops in the order of find_boundary_chains().
[[nodiscard]] HoleLoops find_hole_loops(const PreparedMesh& mesh);

/// Returns a refusal that names a loop by its lowest vertex and lowest face.
[[nodiscard]] Refusal refuse_hole(const PreparedMesh& mesh, const HoleLoop& loop,
                                  std::string reason);

/// Returns the length of a loop.
[[nodiscard]] double length_of(const Soup& soup, const HoleLoop& loop);

/// Returns the distance of a point from the edges of a loop.
[[nodiscard]] double distance_from(const Soup& soup, const HoleLoop& loop, const Vec3& point);

}  // namespace meshalyzer
