#pragma once

#include "meshalyzer/analysis/field_info.h"
#include "meshalyzer/base/statistics.h"
#include "meshalyzer/geometry/curvature.h"
#include "meshalyzer/mesh/side_table.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace meshalyzer {

/// The reason why there may be no value of a curvature.
inline constexpr std::string_view kWhyNoCurvature = "no vertex inside a surface that has one";

/// The statistics of the curvature over the vertices that have one (CurvatureState::Defined).
struct CurvatureStatistics {
  /// The area of a vertex in the computation of its curvature.
  VertexArea area = VertexArea::Mixed;
  Statistics gaussian;
  /// The signed mean curvature, positive where the surface bends away from its normals.
  Statistics mean;
  Statistics k1;
  Statistics k2;
  /// Counts the vertices in each CurvatureState.
  std::array<std::size_t, kCurvatureStates> vertices{};
  /// The sum of the angle defects in radians over all vertices that faces use: 2 pi (V - E + F), to
  /// rounding (Gauss-Bonnet).
  double total_angle_defect = 0.0;
};

/// One row for each curvature, in the order of reports.
inline constexpr std::array kCurvatures{
    QuantityRow<CurvatureStatistics, Statistics>{
        {.info = {.key = "gaussian_curvature",
                  .label = "Gaussian curvature",
                  .definition = "how much a surface is like a ball (positive) or a saddle "
                                "(negative); 1/length²"},
         .if_none = kWhyNoCurvature},
        &CurvatureStatistics::gaussian},
    QuantityRow<CurvatureStatistics, Statistics>{
        {.info = {.key = "mean_curvature",
                  .label = "mean curvature",
                  .definition = "how much a surface bends, on average of all directions: positive "
                                "where it bulges to the side its normals point to; 1/length"},
         .if_none = kWhyNoCurvature},
        &CurvatureStatistics::mean},
    QuantityRow<CurvatureStatistics, Statistics>{
        {.info = {.key = "k1",
                  .label = "principal curvature k1",
                  .definition = "how much the surface bends where it bulges most; 1/length"},
         .if_none = kWhyNoCurvature},
        &CurvatureStatistics::k1},
    QuantityRow<CurvatureStatistics, Statistics>{
        {.info = {.key = "k2",
                  .label = "principal curvature k2",
                  .definition = "how much the surface bends where it bulges least; 1/length"},
         .if_none = kWhyNoCurvature},
        &CurvatureStatistics::k2},
};

/// Measures the curvature at the vertices of a mesh, and returns its statistics.
/// @complexity O(#V + #F).
[[nodiscard]] CurvatureStatistics curvature_statistics(const CutMesh& cut, VertexArea area);

}  // namespace meshalyzer
