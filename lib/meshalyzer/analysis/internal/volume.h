#pragma once

#include "meshalyzer/analysis/analysis.h"

#include <string>

namespace meshalyzer {

/// Returns the reason why a mesh bounds no solid, and so has no volume and no outside: it is open,
/// not manifold, or not consistently oriented. The reason is empty if it bounds one.
///
/// @param attributes  The attributes, of which only `outward` may be missing.
[[nodiscard]] std::string reason_of_no_solid(const Attributes& attributes);

/// Returns the volume of a mesh, the sum of those of its components (see signed_volumes()), or the
/// reason why it has none.
///
/// @param analysis  The analysis, whose attributes and components are set.
[[nodiscard]] Measure<double> total_volume(const Analysis& analysis);

}  // namespace meshalyzer
