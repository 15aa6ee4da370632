#pragma once

#include "meshalyzer/base/types.h"

#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// The tolerances that a user may set. Tolerances left out follow from the others. Lengths are
/// in the unit of the mesh, finite and not negative.
struct ToleranceOptions {
  /// The value of the three lengths that are not set on their own; by default kDefaultTolerance
  /// times the diagonal of the bounding box.
  std::optional<double> tolerance = std::nullopt;
  std::optional<double> degeneracy = std::nullopt;
  std::optional<double> slit = std::nullopt;
  std::optional<double> height = std::nullopt;
  /// The largest angle of a fold, in degrees.
  double max_foldover_angle = 1.0;
};

/// The default of tolerances, as a share of the diagonal of the bounding box.
inline constexpr double kDefaultTolerance = 1e-8;

/// The tolerances that finders and repairs use; lengths are in the unit of the mesh.
struct Tolerances {
  /// An edge or altitude shorter than this is degenerate.
  double degeneracy = 0.0;
  /// Ends of border edges within this are at one place.
  double slit = 0.0;
  /// A foldover lies within this distance of the faces below it.
  double height = 0.0;
  double max_foldover_angle = 1.0;
};

/// Fills in the tolerances that a user has not set.
///
/// @param box  The result of used_box(), of whose diagonal default tolerances are a share; if it is
/// empty, they are 0.
/// @throws InvalidArgument  for a negative or not finite length, or an angle outside 0 ... 180.
[[nodiscard]] Tolerances resolve_tolerances(const ToleranceOptions& options, const Box3& box);

/// Returns options from which resolve_tolerances() makes these tolerances for any box.
[[nodiscard]] ToleranceOptions as_options(const Tolerances& tolerances);

/// Returns a sentence for each contradiction between tolerances: slit or height below degeneracy.
[[nodiscard]] std::vector<std::string> inconsistencies(const Tolerances& tolerances);

}  // namespace meshalyzer
