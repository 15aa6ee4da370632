#pragma once

#include "meshalyzer/repair/holes/internal/existing_edges.h"
#include "meshalyzer/repair/holes/internal/hole_loop.h"
#include "meshalyzer/repair/holes/internal/patch_check.h"
#include "meshalyzer/spatial/box_tree.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// Finds the loops that belong together, as the outer and inner borders of one gap: a hole with an
/// island in it, the missing end of a plate with bores, the rim of a thick wall. An inner border
/// runs against the outer one, and belongs to the nearest across a gap: between nested bands each
/// gap has the inner border of one band and the outer one of the next.
class Islands {
 public:
  /// @param existing  Must outlive this, as the loops must.
  Islands(const PreparedMesh& mesh, const ExistingEdges& existing, std::span<const HoleLoop> loops);

  /// Tells whether there is any loop that could lie on a patch of this one.
  [[nodiscard]] bool may_hold_any(std::size_t loop) const { return !candidates(loop).empty(); }

  /// Returns the inner borders that lie on a patch of an outer one, within a thousandth of that
  /// one's size. Ascending.
  [[nodiscard]] std::vector<std::size_t> lying_on(const Patch& patch, std::size_t of_loop) const;

  /// Returns the inner borders within a tenth of the size of an outer one from its patch: a patch
  /// over a hole in a curved surface keeps no closer to what was lost. Ascending.
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
  [[nodiscard]] std::vector<Index> others_in(const Box3& of_loop, double distance,
                                             std::size_t loop) const;
  /// Returns those of some loops that are inner borders of another one, all within a distance of
  /// its patch.
  [[nodiscard]] std::vector<std::size_t> inner_borders(std::span<const Index> loops,
                                                       std::size_t of_loop, const Patch& patch,
                                                       double distance) const;
  [[nodiscard]] bool run_against_each_other(std::size_t a, std::size_t b) const;
  /// Returns the smallest distance between corners of an outer and an inner border; infinite if
  /// the way leads over faces, or if the loops are too long to be compared.
  [[nodiscard]] double length_of_gap(std::size_t outer, std::size_t inner) const;
  /// Tells whether a loop is nearer to another outer border than to this one. Loops of its own
  /// component do not count.
  [[nodiscard]] bool has_nearer_outer_border(std::size_t loop, std::size_t outer) const;

  const PreparedMesh& mesh_;
  const ExistingEdges& existing_;
  std::span<const HoleLoop> loops_;
  /// The box of each loop.
  std::vector<Box3> boxes_;
  /// The edge component of the faces beyond each loop.
  std::vector<Index> components_;
  BoxTree tree_;
};

}  // namespace meshalyzer
