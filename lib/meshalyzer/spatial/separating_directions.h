#pragma once

#include "meshalyzer/spatial/leaf_triangles.h"

#include <array>
#include <cstddef>

namespace meshalyzer {

/// Tells faces apart whose boxes meet, by directions along which there is a gap between them.
///
/// Most faces that are apart are separated by the plane of one of them, or by a plane that stands
/// on an edge of one. Asked in single precision, of eight faces at a time.
class SeparatingDirections {
 public:
  /// @param lane  Which of the faces.
  SeparatingDirections(const LeafTriangles& faces, std::size_t lane);

  /// Returns those of some other faces of the tree that are not surely apart from this one.
  ///
  /// @param lanes  Which of the eight are asked for, as bits.
  [[nodiscard]] unsigned perhaps_meeting(const LeafTriangles& others, unsigned lanes) const;

 private:
  using Float3 = std::array<float, 3>;

  /// A direction, and from where to where the face reaches along it, widened by more than any
  /// rounding.
  struct Stretch {
    Float3 direction;
    float low;
    float high;
  };

  [[nodiscard]] Stretch stretch_along(const Float3& direction) const;

  std::array<Float3, 3> corners_;
  /// The extents along the normal, and across each edge in the plane.
  std::array<Stretch, 4> stretches_;
};

}  // namespace meshalyzer
