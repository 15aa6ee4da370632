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

  /// Returns the loops in the box of another one with one of these faces beyond an edge. Ascending.
  ///
  /// @param faces  File faces, ascending.
  [[nodiscard]] std::vector<std::size_t> along(std::span<const Index> faces,
                                               std::size_t of_loop) const;

 private:
  /// Returns the maximum distance of a loop from its patch.
  [[nodiscard]] double reach_of(std::size_t loop) const;
  /// Returns the loops in the box of another one, enlarged by that distance.
  [[nodiscard]] std::vector<Index> candidates(std::size_t loop) const;

  const PreparedMesh& mesh_;
  std::span<const HoleLoop> loops_;
  /// The box of each loop.
  std::vector<Box3> boxes_;
  BoxTree tree_;
};

}  // namespace meshalyzer
