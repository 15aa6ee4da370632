#include "meshalyzer/repair/replace/internal/shell_choice.h"

#include "support/run_pass.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace meshalyzer {
namespace {

using Keys = std::vector<Index>;

/// A closed cube, faces 0 to 11, and two open ones, faces 12 to 21 and 22 to 31.
const Soup kThreeCubes = shapes::merged(
    shapes::merged(shapes::cube(), shapes::translated(shapes::open_cube(), {3, 0, 0})),
    shapes::translated(shapes::open_cube(), {6, 0, 0}));

ChosenShells choose(const ShellChoice& choice) {
  ChosenShells chosen;
  static_cast<void>(run_pass(kThreeCubes, [&](const PassInput& input) {
    chosen = choose_shells(input, choice);
    return PassResult{};
  }));
  return chosen;
}

Keys from_to(Index first, Index last) {
  Keys keys(last - first + 1);
  std::iota(keys.begin(), keys.end(), first);
  return keys;
}

TEST(ChooseShells, TakesOpenComponentsThatAreNamed) {
  const ChosenShells chosen = choose({.face_keys = {0, 12}, .hidden_points = {}});
  EXPECT_EQ(chosen.face_keys, from_to(12, 21));
  EXPECT_EQ(chosen.other_open_keys, from_to(22, 31));
}

TEST(ChooseShells, TakesClosedOnesIfAskedTo) {
  const ChosenShells chosen =
      choose({.face_keys = {0, 12}, .closed_too = true, .hidden_points = {}});
  EXPECT_EQ(chosen.face_keys, from_to(0, 21));
  EXPECT_EQ(chosen.other_open_keys, from_to(22, 31));
}

TEST(ChooseShells, TakesOpenComponentsWhoseBoxHoldsAPoint) {
  const ChosenShells chosen =
      choose({.face_keys = {}, .hidden_points = {{0.5, 0.5, 0.5}, {6.5, 0.5, 0.5}}});
  EXPECT_EQ(chosen.face_keys, from_to(22, 31));
  EXPECT_EQ(chosen.other_open_keys, from_to(12, 21));
}

}  // namespace
}  // namespace meshalyzer
