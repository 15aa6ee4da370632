#include "meshalyzer/topology/genus.h"

namespace meshalyzer {

std::optional<std::int64_t> genus(const EulerCounts& counts) {
  const auto characteristic = static_cast<std::int64_t>(counts.vertices) -
                              static_cast<std::int64_t>(counts.edges) +
                              static_cast<std::int64_t>(counts.faces);
  const std::int64_t twice = 2 - static_cast<std::int64_t>(counts.boundaries) - characteristic;
  if (twice < 0 || twice % 2 != 0) return std::nullopt;
  return twice / 2;
}

}  // namespace meshalyzer
