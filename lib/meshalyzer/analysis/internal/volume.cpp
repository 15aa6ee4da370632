#include "meshalyzer/analysis/internal/volume.h"

#include "meshalyzer/base/sum.h"

#include <optional>
#include <utility>

namespace meshalyzer {

std::string reason_of_no_solid(const Attributes& attributes) {
  if (!attributes.closed.value) return attributes.closed.reason;
  if (!*attributes.closed.value) return "the mesh is not closed";
  if (!attributes.consistent.value) return attributes.consistent.reason;
  return *attributes.consistent.value ? "" : "the mesh is not consistently oriented";
}

Measure<double> total_volume(const Analysis& analysis) {
  if (std::string reason = reason_of_no_solid(analysis.attributes); !reason.empty()) {
    return {.value = std::nullopt, .reason = std::move(reason)};
  }
  CompensatedSum sum;
  for (const ComponentAnalysis& c : analysis.components) {
    if (!c.volume) return {.value = std::nullopt, .reason = "it is too large for a double"};
    sum.add(*c.volume);
  }
  return {.value = sum.value(), .reason = {}};
}

}  // namespace meshalyzer
