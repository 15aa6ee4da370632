#include "meshalyzer/analysis/measure_again.h"

#include "meshalyzer/analysis/internal/measures.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/mesh/finite_positions.h"

#include <utility>

namespace meshalyzer {

MeasuredValues measure_again(const Soup& soup) {
  require_finite_positions(soup);
  const CutMesh cut = build(soup);
  // Values by component are not needed, so that all faces may count as one.
  const Components one{1, std::vector<Index>(cut.mesh.n_faces(), 0)};
  Analysis analysis;
  AnalysisOptions options;
  options.keep_values = true;
  static_cast<void>(measure(cut, one, options, analysis));
  return std::move(analysis.values);
}

}  // namespace meshalyzer
