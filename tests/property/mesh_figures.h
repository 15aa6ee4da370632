#pragma once

#include "meshalyzer/analysis/analysis.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace meshalyzer {

/// A measured value, and how it changes with the size of the mesh.
struct RealFigure {
  double value = 0.0;
  /// What rounding is relative to: the size of the terms that were added up.
  double magnitude = 0.0;
  /// 1 for a length, 2 for an area, 3 for a volume, 0 for an angle or a ratio.
  int dimension = 0;
};

/// What an analysis says of a mesh without naming any record: the same whichever way records are
/// numbered and wherever the mesh lies.
struct MeshFigures {
  /// Counts, attributes (-1 where undefined), genus, and the intersecting pairs of each kind.
  std::map<std::string, std::int64_t> counts;
  /// The same of each component.
  std::multiset<std::vector<std::int64_t>> components;
  std::map<std::string, RealFigure> reals;
};

[[nodiscard]] MeshFigures figures_of(const Analysis& analysis);

/// The differences that figures may have.
struct FigureTolerance {
  /// The factor by which the lengths of the second mesh are longer.
  double scale = 1.0;
  /// Relative error of reals.
  double relative = 0.0;
};

/// Expects that two meshes have the same figures but for size and rounding.
void expect_same_figures(const MeshFigures& expected, const MeshFigures& actual,
                         const FigureTolerance& tolerance);

}  // namespace meshalyzer
