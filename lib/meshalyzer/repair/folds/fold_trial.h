#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to the repair module.

/// A face as it would be.
struct PlacedFace {
  /// File vertices.
  Triangle vertices;
  Corners corners;
};

/// Faces that would stand in the place of others. Only refers.
struct FoldTrial {
  std::span<const PlacedFace> faces;
  /// Faces next to them that stay, and to which they must be in no fold, nor touch them.
  std::span<const PlacedFace> around;
  /// Of the finder, in degrees.
  double max_foldover_angle = 0.0;
  /// Altitudes must be above this.
  double degeneracy = 0.0;
};

/// Whether two faces have a point in common that is not on what they share by vertex.
[[nodiscard]] bool is_contact(const PlacedFace& a, const PlacedFace& b);

/// How well the worst of the faces is shaped (see shape_quality()); nothing where one is too flat,
/// is folded onto a neighbour, or touches another.
///
/// @complexity O(#faces (#faces + #around)).
[[nodiscard]] std::optional<double> quality_of(const FoldTrial& trial);

}  // namespace meshalyzer
