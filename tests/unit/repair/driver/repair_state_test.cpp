#include "meshalyzer/repair/driver/internal/repair_state.h"

#include "meshalyzer/repair/edits/apply_edits.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

using Pairs = std::vector<IntersectingPair>;
using Skipped = std::vector<std::uint8_t>;

/// Returns a change of a tangle of loose faces: every third is turned over, moved at a corner,
/// removed, given a corner of the next face, or gets a copy of itself with another corner. Each is
/// an operation.
Edits random_edits(const Soup& soup, std::mt19937& random) {
  Edits edits;
  std::set<Index> moved;
  for (Index face = 0; face + 1 < soup.n_faces(); face += 3) {
    const auto [a, b, c] = soup.triangles[face];
    const Index next = soup.triangles[face + 1][0];
    const Vec3 place(uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1));
    const Index op = edits.begin_operation();
    switch (below(random, 5)) {
      case 0:
        edits.changed_faces.push_back({op, face, {a, c, b}});
        break;
      case 1:
        if (moved.insert(a).second) edits.moved_vertices.push_back({op, a, place});
        break;
      case 2:
        edits.removed_faces.push_back({op, face});
        break;
      case 3:
        edits.changed_faces.push_back({op, face, {a, b, next}});
        break;
      default:
        edits.added_faces.push_back(
            {op,
             {a, b, static_cast<Index>(soup.n_vertices() + edits.added_vertices.size())},
             face});
        edits.added_vertices.push_back({op, place});
    }
  }
  return edits;
}

/// Returns about half of the operations.
Skipped some_operations(const Edits& edits, std::mt19937& random) {
  Skipped skipped(edits.n_operations);
  for (std::uint8_t& is_skipped : skipped) is_skipped = below(random, 2) == 0 ? 1 : 0;
  return skipped;
}

/// The state that a change leads to, and what it affects.
struct Changed {
  RepairState state;
  AffectedElements affected;

  Changed(const RepairState& before, const Edits& edits, std::span<const std::uint8_t> skipped,
          const RepairState* trial = nullptr)
      : Changed(before, apply_edits(before.tracked(), edits, skipped), edits, skipped, trial) {}

 private:
  Changed(const RepairState& before, TrackedMesh after, const Edits& edits,
          std::span<const std::uint8_t> skipped, const RepairState* trial)
      : state(after, Tolerances(), {before, trial},
              find_affected_elements(before.tracked(), edits, SkippedOperations(skipped), after)),
        affected(
            find_affected_elements(before.tracked(), edits, SkippedOperations(skipped), after)) {}
};

/// Expects the pairs that a search of the whole mesh finds, and those of them with an affected
/// face.
void expect_all_pairs(const Changed& changed) {
  const RepairState searched(changed.state.tracked(), Tolerances());
  const Pairs& all = searched.mesh().intersecting_pairs();
  EXPECT_EQ(changed.state.mesh().intersecting_pairs(), all);
  const std::vector<Index>& keys = changed.state.tracked().face_keys;
  Pairs affected;
  std::copy_if(all.begin(), all.end(), std::back_inserter(affected),
               [&](const IntersectingPair& pair) {
                 const auto& faces = changed.affected.faces_after;
                 return !operations_on(faces, keys[pair.face_a]).empty() ||
                        !operations_on(faces, keys[pair.face_b]).empty();
               });
  EXPECT_EQ(changed.state.affected_pairs(), affected);
}

TEST(RepairState, PairsAfterAChangeAreThoseOfASearchOfTheWholeMesh) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const RepairState before(track_mesh(shapes::tangle(60)), Tolerances());
    ASSERT_FALSE(before.mesh().intersecting_pairs().empty());
    const Edits edits = random_edits(before.tracked().soup, random);
    expect_all_pairs({before, edits, some_operations(edits, random)});
  }
}

TEST(RepairState, PairsAfterASecondTrialAreThoseOfASearchOfTheWholeMesh) {
  std::mt19937 random(2);
  for (int i = 0; i < 20; ++i) {
    const RepairState before(track_mesh(shapes::tangle(60)), Tolerances());
    const Edits edits = random_edits(before.tracked().soup, random);
    const Changed trial(before, edits, Skipped(edits.n_operations, 0));
    // With one operation left out, most faces are as in the trial; with half of them, many added
    // faces have the keys of others.
    Skipped skipped(edits.n_operations, 0);
    skipped[below(random, static_cast<Index>(skipped.size()))] = 1;
    expect_all_pairs({before, edits, skipped, &trial.state});
    expect_all_pairs({before, edits, some_operations(edits, random), &trial.state});
  }
}

TEST(RepairState, ChangeAfterAnotherStartsFromItsPairs) {
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    const RepairState before(track_mesh(shapes::tangle(60)), Tolerances());
    const Edits first = random_edits(before.tracked().soup, random);
    const Changed between(before, first, some_operations(first, random));
    const Edits second = random_edits(between.state.tracked().soup, random);
    expect_all_pairs({between.state, second, some_operations(second, random)});
  }
}

}  // namespace
}  // namespace meshalyzer
