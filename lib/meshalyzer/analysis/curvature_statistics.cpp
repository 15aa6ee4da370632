#include "meshalyzer/analysis/curvature_statistics.h"

#include "meshalyzer/base/sum.h"

#include <vector>

namespace meshalyzer {
namespace {

/// Summarises the values of the vertices that have a curvature.
Statistics summarize_defined(const Curvature& curvature, const std::vector<double>& column) {
  std::vector<double> values;
  values.reserve(column.size());
  for (std::size_t v = 0; v < column.size(); ++v) {
    if (curvature.state[v] == CurvatureState::Defined) {
      values.push_back(column[v]);
    }
  }
  return summarize(values);
}

}  // namespace

CurvatureStatistics curvature_statistics(const CutMesh& cut, VertexArea area) {
  const Curvature curvature = measure_curvature(cut, area);
  CurvatureStatistics statistics;
  statistics.area = area;
  statistics.gaussian = summarize_defined(curvature, curvature.gaussian);
  statistics.mean = summarize_defined(curvature, curvature.mean);
  statistics.k1 = summarize_defined(curvature, curvature.k1);
  statistics.k2 = summarize_defined(curvature, curvature.k2);
  CompensatedSum defect;
  for (std::size_t v = 0; v < curvature.state.size(); ++v) {
    ++statistics.vertices[static_cast<std::size_t>(curvature.state[v])];
    if (curvature.state[v] != CurvatureState::Unused) {
      defect.add(curvature.angle_defect[v]);
    }
  }
  statistics.total_angle_defect = defect.value();
  return statistics;
}

}  // namespace meshalyzer
