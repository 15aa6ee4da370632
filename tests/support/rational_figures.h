#pragma once

#include "meshalyzer/base/types.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <array>
#include <variant>
#include <vector>

namespace meshalyzer::test {

/// Geometry over the rationals with CGAL's constructions, for oracles only.
using Rational = CGAL::Gmpq;
using RationalKernel = CGAL::Simple_cartesian<Rational>;
using RationalPoint = RationalKernel::Point_3;
using RationalVector = RationalKernel::Vector_3;
using RationalSegment = RationalKernel::Segment_3;
using RationalTriangle = RationalKernel::Triangle_3;
using RationalFigure = std::variant<RationalPoint, RationalSegment, RationalTriangle>;

[[nodiscard]] RationalPoint rational_point(const Vec3& v);

/// Returns the convex hull of three points as the simplest figure.
[[nodiscard]] RationalFigure hull_of(const std::array<RationalPoint, 3>& p);

/// Returns the corners of the intersection of two figures (a convex set).
[[nodiscard]] std::vector<RationalPoint> intersect(const RationalFigure& a,
                                                   const RationalFigure& b);

}  // namespace meshalyzer::test
