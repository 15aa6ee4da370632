#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/prepared/prepared_mesh.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// Faces that fill a hole.
struct Patch {
  /// The corners of the faces by file vertex; n_vertices + i is added vertex i.
  std::vector<Triangle> triangles;
  std::vector<Vec3> added;
};

/// Returns the position of a vertex of a patch.
[[nodiscard]] const Vec3& position_of(const Soup& mesh, const Patch& patch, Index v);

/// Returns the corners of a triangle of a patch.
[[nodiscard]] Corners corners_of(const Soup& mesh, const Patch& patch, const Triangle& t);

/// The faults of a patch.
struct PatchFaults {
  /// Tells whether the patch by itself is not a consistently oriented manifold.
  bool is_torn = false;
  /// The faces of the patch, by index, that are in contact with the mesh or with each other.
  /// Ascending.
  std::vector<Index> meeting;
  /// The file faces that the patch is in contact with. Ascending.
  std::vector<Index> met_faces;

  [[nodiscard]] bool empty() const { return !is_torn && meeting.empty(); }
};

/// Checks, exactly, that a patch intersects neither the mesh nor itself (doc/definitions.md). A
/// contact at nothing but two copies of one vertex does not count: the faces beyond the border have
/// it already, and another pass parts the copies.
///
/// @complexity  O(n log #F + candidates).
[[nodiscard]] PatchFaults check_patch(const PreparedMesh& mesh, const Patch& patch);

/// Tells whether check_patch() finds no fault. The search ends at the first one.
[[nodiscard]] bool is_sound(const PreparedMesh& mesh, const Patch& patch);

/// Finds the patches that intersect an earlier one that is kept: the result is 1 for patches that
/// are kept.
[[nodiscard]] std::vector<std::uint8_t> keep_apart(const PreparedMesh& mesh,
                                                   std::span<const Patch> patches);

/// A patch as a mesh of its own.
struct PatchSoup {
  Soup soup;
  /// Indexed by vertex of the soup: the vertex of the patch that it is; ascending.
  std::vector<Index> vertices;
};

[[nodiscard]] PatchSoup make_soup(const Soup& mesh, const Patch& patch);

}  // namespace meshalyzer
