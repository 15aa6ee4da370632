#pragma once

#include "meshalyzer/boolean/inside_rule.h"
#include "meshalyzer/boolean/operands.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// The operands of a difference and, as two more of them, pads: thin solids round some faces, which
/// are subtracted too, so that what is left stays away from these faces.
class PaddedOperands {
 public:
  explicit PaddedOperands(const Operands& operands);

  /// Adds a pad round some faces of a mesh. It is thick at the vertices of these faces, on both
  /// sides of all faces that have one of them, and thins out to nothing at their other vertices.
  /// Where no direction leaves all faces at a vertex, a small tetrahedron round it is added.
  ///
  /// @param faces      The faces, each of them of the mesh.
  /// @param thickness  How far the pad reaches from the planes of the faces, on their outside.
  /// @complexity       O(#F of the mesh).
  void add_pad(const Soup& mesh, std::span<const Index> faces, double thickness);

  /// Returns all operands, of which the pads are the last two. Their vertices and faces come after
  /// those of the others.
  [[nodiscard]] Operands operands() const { return {soup_, of_face_, n_operands_}; }

  /// Returns the rule by which the others and the pads are taken away from the first operand.
  [[nodiscard]] static InsideRule rule();

  /// No point of a pad is farther from the faces than this many times its thickness.
  static constexpr double kMostPadding = 8.0;

 private:
  Index add_vertex(const Vec3& position);
  void add_face(const Triangle& corners, std::size_t operand);
  void add_tetrahedron(const Vec3& middle, double size);

  /// With positions and faces only.
  Soup soup_;
  std::vector<Index> of_face_;
  std::size_t n_operands_;
};

}  // namespace meshalyzer
