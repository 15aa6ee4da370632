#include "meshalyzer/repair/split/internal/parting_memory.h"

#include "support/run_pass.h"
#include "support/shapes.h"
#include "unit/repair/split/split_passes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace meshalyzer {
namespace {

constexpr Index kNearby = 8;
constexpr Index kFar = 12;

/// Two tetrahedra whose tips touch, and two others: one near them, and one farther away.
Soup touching_tips() {
  const Soup tips = split(shapes::two_tetrahedra_sharing_vertex()).tracked.soup;
  const Soup nearby = shapes::translated(shapes::tetrahedron(), {2, 2, 2});
  const Soup far = shapes::translated(shapes::tetrahedron(), {20, 0, 0});
  return shapes::merged(shapes::merged(tips, nearby), far);
}

/// Notes that the tips cannot be parted, and recalls it.
class PartingMemoryTest : public ::testing::Test {
 protected:
  PartingMemoryTest() : tracked_(track_mesh(touching_tips())), prepared_(tracked_.soup) {
    EXPECT_EQ(contacts_.places.size(), 1U);
  }

  void note(std::size_t n_checks, bool has_run_out) {
    const Box3 region(Vec3(-2.5, -2.5, -2.5), Vec3(2.5, 2.5, 2.5));
    memory().note(key(), {.region = region, .n_checks = n_checks, .has_run_out = has_run_out});
  }

  [[nodiscard]] std::optional<std::size_t> recall(std::size_t n_checks, double first_step = 1e-16) {
    return memory(first_step).recall(key(first_step), n_checks);
  }

  [[nodiscard]] std::uint64_t key(double first_step = 1e-16) {
    return memory(first_step).key_of(contacts_.places[0]);
  }

  [[nodiscard]] PartingMemory memory(double first_step = 1e-16) {
    return {failed_, tracked_, moved_, first_step};
  }

  void move(Index vertex) {
    moved_.move(std::array{vertex}, moved_.position(vertex) + Vec3(0.125, 0, 0));
  }

  TrackedMesh tracked_;
  PreparedMesh prepared_;
  ContactPlaces contacts_ = find_contact_places(tracked_, prepared_);
  MovedMesh moved_{prepared_};

 private:
  FailedPartings failed_;
};

TEST_F(PartingMemoryTest, KnowsNothingBeforeItIsNoted) {
  EXPECT_FALSE(memory().has_failed(key()));
  EXPECT_FALSE(recall(1000));
}

TEST_F(PartingMemoryTest, NoSearchFindsAMoveWithoutChecks) {
  EXPECT_EQ(recall(0), 0U);
}

TEST_F(PartingMemoryTest, RecallsTheChecksThatWouldBeInVain) {
  note(100, false);
  EXPECT_TRUE(memory().has_failed(key()));
  EXPECT_EQ(recall(1000), 100U);
  EXPECT_EQ(recall(50), 50U);
}

TEST_F(PartingMemoryTest, SearchThatHasRunOutOfChecksIsMadeAgainWithMore) {
  note(100, true);
  EXPECT_EQ(recall(100), 100U);
  EXPECT_FALSE(recall(101));
}

TEST_F(PartingMemoryTest, ForgetsOnceAFaceNearbyHasMoved) {
  note(100, false);
  move(kFar);
  EXPECT_TRUE(recall(1000));
  move(kNearby);
  EXPECT_FALSE(recall(1000));
  EXPECT_TRUE(memory().has_failed(key()));
}

TEST_F(PartingMemoryTest, AnotherPositionOrFirstStepIsAnotherSearch) {
  note(100, false);
  EXPECT_FALSE(recall(1000, 2e-16));
  move(contacts_.places[0].units[0][0]);
  EXPECT_FALSE(memory().has_failed(key()));
}

}  // namespace
}  // namespace meshalyzer
