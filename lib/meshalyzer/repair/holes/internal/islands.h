#pragma once

#include "meshalyzer/repair/holes/internal/hole_loop.h"
#include "meshalyzer/repair/holes/internal/patch_check.h"
#include "meshalyzer/spatial/box_tree.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// Finds the loops that belong together, as the outer and inner borders of one gap: a hole with an
/// island in it, the missing end of a plate with bores, the rim of a thick wall.
class Islands {
 public:
  /// @param loops  Must outlive this.
  Islands(const PreparedMesh& mesh, std::span<const HoleLoop> loops);

  /// Tells whether there is any loop that could lie on a patch of this one.
  [[nodiscard]] bool may_hold_any(std::size_t loop) const { return !candidates(loop).empty(); }

  /// Returns the loops that lie on a patch of another one, within a thousandth of that one's size.
  /// Ascending.
  [[nodiscard]] std::vector<std::size_t> lying_on(const Patch& patch, std::size_t of_loop) const;

  /// Returns the loops that run against another one within a twentieth of that one's size from its
  /// patch: a patch over a hole in a curved surface keeps no closer to what was lost. Ascending.
  [[nodiscard]] std::vector<std::size_t> facing(const Patch& patch, std::size_t of_loop) const;

  /// Returns the loops in the box of another one with one of these faces beyond an edge. Ascending.
  ///
  /// @param faces  File faces, ascending.
  [[nodiscard]] std::vector<std::size_t> along(std::span<const Index> faces,
                                               std::size_t of_loop) const;

 private:
  /// Returns the length that is a fraction of the size of a loop.
  [[nodiscard]] double share_of(std::size_t loop, double fraction) const;
  /// Returns the other loops in the box of a loop, enlarged by the maximum distance of lying_on().
  [[nodiscard]] std::vector<Index> candidates(std::size_t loop) const;
  /// Returns the other loops in a box enlarged by a distance.
  [[nodiscard]] std::vector<Index> others_in(Box3 box, double distance, std::size_t loop) const;
  /// Returns those of some loops that are all within a distance of a patch.
  [[nodiscard]] std::vector<std::size_t> within(double distance, const Patch& patch,
                                                std::span<const Index> loops) const;

  const PreparedMesh& mesh_;
  std::span<const HoleLoop> loops_;
  /// The box of each loop.
  std::vector<Box3> boxes_;
  BoxTree tree_;
};

}  // namespace meshalyzer
