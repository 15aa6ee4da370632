#include "meshalyzer/defects/tolerances.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/base/require.h"

#include <string_view>

namespace meshalyzer {
namespace {

/// Returns a share of the diagonal of a box, which may itself be too long for a double.
double share_of_diagonal(double share, const Box3& box) {
  if (box.isEmpty()) return 0.0;
  const Vec3 quarter = box.max() / 4 - box.min() / 4;
  return quarter.stableNorm() * (4 * share);
}

void require_valid(const ToleranceOptions& options) {
  require_length("the tolerance", options.tolerance);
  require_length("the degeneracy tolerance", options.degeneracy);
  require_length("the slit tolerance", options.slit);
  require_length("the height tolerance", options.height);
  require_angle("the max fold-over angle", options.max_foldover_angle, 180.0);
}

struct NamedLength {
  std::string_view name;
  double value;
};

std::string named(const NamedLength& length) {
  std::string text = "the ";
  text += length.name;
  text += " tolerance (";
  append_shortest(text, length.value);
  text += ')';
  return text;
}

}  // namespace

Tolerances resolve_tolerances(const ToleranceOptions& options, const Box3& box) {
  require_valid(options);
  const double common =
      options.tolerance ? *options.tolerance : share_of_diagonal(kDefaultTolerance, box);
  return {.degeneracy = options.degeneracy.value_or(common),
          .slit = options.slit.value_or(common),
          .height = options.height.value_or(common),
          .max_foldover_angle = options.max_foldover_angle};
}

ToleranceOptions as_options(const Tolerances& tolerances) {
  return {.tolerance = std::nullopt,
          .degeneracy = tolerances.degeneracy,
          .slit = tolerances.slit,
          .height = tolerances.height,
          .max_foldover_angle = tolerances.max_foldover_angle};
}

std::vector<std::string> inconsistencies(const Tolerances& tolerances) {
  std::vector<std::string> sentences;
  const NamedLength degeneracy{"degeneracy", tolerances.degeneracy};
  for (const NamedLength& other :
       {NamedLength{"slit", tolerances.slit}, NamedLength{"height", tolerances.height}}) {
    if (other.value < degeneracy.value) {
      sentences.push_back(named(other));
      sentences.back() += " is below ";
      sentences.back() += named(degeneracy);
    }
  }
  return sentences;
}

}  // namespace meshalyzer
