#pragma once

#include "meshalyzer/mesh/soup.h"

#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// What a user may say of tolerances; what is left out follows from the rest. Lengths in the mesh's
/// unit, finite and not negative.
struct ToleranceOptions {
  /// For all three; by default kDefaultTolerance of the diagonal of the bounding box.
  std::optional<double> tolerance = std::nullopt;
  std::optional<double> degeneracy = std::nullopt;
  std::optional<double> slit = std::nullopt;
  std::optional<double> height = std::nullopt;
  /// Degrees.
  double max_foldover_angle = 1.0;
};

/// Of the diagonal of the bounding box.
inline constexpr double kDefaultTolerance = 1e-8;

/// The tolerances that finders and repairs go by: lengths in the mesh's unit.
struct Tolerances {
  /// An edge or altitude shorter than this is degenerate.
  double degeneracy = 0.0;
  /// Ends of border edges within this are at one place.
  double slit = 0.0;
  /// A foldover lies within this of the faces that it lies on.
  double height = 0.0;
  double max_foldover_angle = 1.0;
};

/// The box that default tolerances are a share of: of the vertices that faces of the complex use.
/// Empty where there are none.
///
/// @complexity O(#F).
[[nodiscard]] Box3 used_box(const Soup& soup);

/// Fills in what was not said.
///
/// @param box  As used_box(); may be empty, then defaults are 0.
/// @throws InvalidArgument  for a negative or not finite length, or an angle outside 0 ... 180.
[[nodiscard]] Tolerances resolve_tolerances(const ToleranceOptions& options, const Box3& box);

/// Options that say just these tolerances: for another search that is to go by the same.
[[nodiscard]] ToleranceOptions as_options(const Tolerances& tolerances);

/// What contradicts what, a sentence each: slit or height below degeneracy.
[[nodiscard]] std::vector<std::string> inconsistencies(const Tolerances& tolerances);

}  // namespace meshalyzer
