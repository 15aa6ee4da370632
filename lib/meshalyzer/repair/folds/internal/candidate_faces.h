#pragma once

#include "meshalyzer/repair/rules/internal/contact_rule.h"

#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to the repair module.

/// Faces that would replace others. This holds references only.
struct CandidateFaces {
  std::span<const PlacedFace> faces;
  /// Adjacent faces that stay, which the candidates must neither touch nor be folded onto.
  std::span<const PlacedFace> around;
  /// The foldover angle of the defect finder, in degrees.
  double max_foldover_angle = 0.0;
  /// The minimum altitude, exclusive.
  double degeneracy = 0.0;
};

/// Returns the shape quality of the worst of the faces (see shape_quality()); nothing if one is too
/// flat, is folded onto a neighbour, or touches another.
///
/// @complexity O(#faces (#faces + #around)).
[[nodiscard]] std::optional<double> quality_of(const CandidateFaces& candidate);

}  // namespace meshalyzer
