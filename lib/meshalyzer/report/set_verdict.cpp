#include "meshalyzer/report/set_verdict.h"

namespace meshalyzer {
namespace {

bool are_apart(const SetIntersections& found) {
  return found.pairs.empty() && found.contained.empty() && found.partly_contained.empty();
}

}  // namespace

std::optional<bool> is_good(const SetAnalysis& set) {
  if (!set.good) {
    return std::nullopt;
  }
  return set.not_good.empty() && (!set.intersections || are_apart(*set.intersections));
}

}  // namespace meshalyzer
