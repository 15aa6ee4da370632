#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/boolean/combine_solids.h"
#include "meshalyzer/repair/cut/internal/cut_surface.h"
#include "meshalyzer/repair/pass.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// Faces of a mesh, and solids that are combined with them by a boolean operation.
class MeshOperands {
 public:
  /// The operand of all faces of the mesh.
  static constexpr Index kMesh = 0;

  explicit MeshOperands(const Soup& mesh) { soup_.positions = mesh.positions; }

  Index add_vertex(const Vec3& p);
  /// Adds a face of the mesh, or one more that closes it.
  ///
  /// @param origin  The face of the mesh that it is, or kNoIndex.
  void add_face(const Triangle& t, Index origin = kNoIndex) { add(t, kMesh, origin); }
  /// Adds a solid, which has vertices of its own.
  void add_solid(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                 Index operand);

  /// Combines the operands.
  ///
  /// @param count  How many there are, with the mesh.
  [[nodiscard]] CombinedSolid combine(std::size_t count, const InsideRule& rule,
                                      const CombineOptions& options) const;

  /// Returns the result of combine(), with the face of the mesh that each face is a part of, or the
  /// nearest one.
  ///
  /// @param input  Has the mesh.
  /// @complexity   O(log #F) for each face of an added solid.
  [[nodiscard]] CutSurface surface_of(const CombinedSolid& solid, const PassInput& input) const;

 private:
  void add(const Triangle& t, Index operand, Index origin);

  Soup soup_;
  std::vector<Index> of_face_;
  /// #faces: the face of the mesh that each is, or kNoIndex.
  std::vector<Index> origins_;
};

}  // namespace meshalyzer
