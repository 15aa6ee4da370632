#pragma once

#include "meshalyzer/repair/driver/internal/contact_rule.h"

#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to the repair module.

/// Faces that would replace others. This holds references only.
struct CandidateFaces {
  std::span<const PlacedFace> faces;
  /// Faces next to them that stay, and to which they must be in no fold, nor touch them.
  std::span<const PlacedFace> around;
  /// The foldover angle of the defect finder, in degrees.
  double max_foldover_angle = 0.0;
  /// Altitudes must be above this.
  double degeneracy = 0.0;
};

/// Returns how well the worst of the faces is shaped (see shape_quality()); nothing where one is
/// too flat, is folded onto a neighbour, or touches another.
///
/// @complexity O(#faces (#faces + #around)).
[[nodiscard]] std::optional<double> quality_of(const CandidateFaces& candidate);

}  // namespace meshalyzer
