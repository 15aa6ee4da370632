#include "meshalyzer/boolean/inside_rule.h"

#include <algorithm>

namespace meshalyzer {
namespace {

bool is_inside(int winding) {
  return winding >= 1;
}

}  // namespace

InsideRule union_rule() {
  return [](std::span<const int> windings) {
    return std::any_of(windings.begin(), windings.end(), is_inside);
  };
}

InsideRule intersection_rule() {
  return [](std::span<const int> windings) {
    return std::all_of(windings.begin(), windings.end(), is_inside);
  };
}

InsideRule difference_rule() {
  return [](std::span<const int> windings) {
    return is_inside(windings.front()) &&
           std::none_of(windings.begin() + 1, windings.end(), is_inside);
  };
}

}  // namespace meshalyzer
