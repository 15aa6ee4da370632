#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/prepared/prepared_mesh.h"

#include <map>
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

  [[nodiscard]] bool empty() const { return !is_torn && meeting.empty(); }
};

/// Checks, exactly, that the triangulations that are tried for a hole intersect neither the mesh
/// nor themselves (doc/definitions.md). A contact at nothing but two copies of one vertex does not
/// count: the faces beyond the border have it already, and another pass parts the copies.
///
/// Most triangles are in many of these triangulations. Whether one of them is in contact with the
/// mesh is found once.
class TriangulationChecker {
 public:
  /// @param mesh  Must outlive this unchanged.
  explicit TriangulationChecker(const PreparedMesh& mesh) : mesh_(mesh) {}

  /// @param patch  Has no added vertices.
  /// @complexity   O(n log #F + candidates).
  [[nodiscard]] PatchFaults check(const Patch& patch);

 private:
  void compare_new_triangles(const Patch& patch);

  const PreparedMesh& mesh_;
  /// By triangle: whether it is in contact with the mesh.
  std::map<Triangle, bool> is_meeting_;
};

/// Tells whether a patch has no fault. The search ends at the first one.
[[nodiscard]] bool is_sound(const PreparedMesh& mesh, const Patch& patch);

/// Returns the file faces that a patch is in contact with, ascending; none if it is torn.
[[nodiscard]] std::vector<Index> faces_met(const PreparedMesh& mesh, const Patch& patch);

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
