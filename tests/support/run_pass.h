#pragma once

#include "meshalyzer/repair/edits/apply_edits.h"
#include "meshalyzer/repair/pass.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace meshalyzer {

/// The result of a pass.
struct PassRun {
  TrackedMesh tracked;
  /// The refusals of the last round.
  std::vector<Refusal> refused;
  std::size_t operations = 0;
  std::size_t rounds = 0;
};

/// Returns the box of all vertices of a soup.
[[nodiscard]] inline Box3 box_of(const Soup& soup) {
  Box3 box;
  for (const Vec3& p : soup.positions) box.extend(p);
  return box;
}

/// Returns limits that permit any change up to a hundredth of the diagonal.
[[nodiscard]] inline RepairLimits wide_limits(const Soup& soup) {
  return {.max_deviation = 0.01 * box_of(soup).diagonal().norm(),
          .fixed_vertices = {},
          .groups = Groups::Names};
}

/// Returns a pass that remembers what it learns of a mesh when it is run again.
[[nodiscard]] inline PassFunction remembering(PassMemory& memory, PassFunction pass) {
  return [&memory, pass = std::move(pass)](PassInput input) {
    input.memory = &memory;
    return pass(input);
  };
}

/// Runs a pass until it proposes nothing more, and applies all its edits.
[[nodiscard]] inline PassRun run_pass(const Soup& soup, const PassFunction& pass,
                                      const RepairLimits& limits,
                                      const ToleranceOptions& tolerances = {}) {
  constexpr std::size_t kMaxRounds = 100;
  PassRun run{.tracked = track_mesh(soup), .refused = {}, .operations = 0, .rounds = 0};
  while (true) {
    const PreparedMesh mesh(run.tracked.soup);
    const Tolerances resolved = resolve_tolerances(tolerances, box_of(run.tracked.soup));
    PassResult result = pass({soup, run.tracked, mesh, resolved, limits});
    run.refused = std::move(result.refused);
    if (result.edits.empty()) return run;
    run.operations += result.edits.n_operations;
    if (++run.rounds > kMaxRounds) {
      ADD_FAILURE() << "the pass never ends";
      return run;
    }
    run.tracked = apply_edits(run.tracked, result.edits);
  }
}

[[nodiscard]] inline PassRun run_pass(const Soup& soup, const PassFunction& pass) {
  return run_pass(soup, pass, wide_limits(soup));
}

}  // namespace meshalyzer
