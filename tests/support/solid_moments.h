#pragma once

#include "support/rational_figures.h"

#include <array>
#include <vector>

namespace meshalyzer::test {

/// A triangle over the rationals.
using RationalCorners = std::array<RationalPoint, 3>;

/// The integrals of 1, x, y and z over a region.
using Moments = std::array<Rational, 4>;

/// Returns the moments of the region that triangles go round at least once, exactly and by brute
/// force: it is cut into slabs between all heights where a cross-section changes its shape, and
/// each cross-section into strips in the same way. No predicate or structure of the library has a
/// part in it.
///
/// @param triangles  They cross every edge equally often in both directions; each has an area.
/// @complexity       O(n^3) heights for n triangles that all intersect: for some tens of them.
[[nodiscard]] Moments moments_inside(const std::vector<RationalCorners>& triangles);

/// Returns the moments of the region that a surface encloses, by the divergence theorem: what it
/// goes round n times counts n times.
[[nodiscard]] Moments moments_enclosed(const std::vector<RationalCorners>& triangles);

}  // namespace meshalyzer::test
