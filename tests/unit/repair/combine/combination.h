#pragma once

#include "meshalyzer/boolean/combine_solids.h"

#include <vector>

namespace meshalyzer {

/// Two meshes, and what an operation makes of them: the first one without the second if nothing
/// else is said.
struct Combination {
  Combination(const Soup& a, const Soup& b, const InsideRule& rule = difference_rule())
      : meshes{a, b},
        all(concatenate(meshes)),
        solid(combine_solids(operands_of(all, meshes), rule)) {}

  std::vector<Soup> meshes;
  Soup all;
  CombinedSolid solid;
};

}  // namespace meshalyzer
