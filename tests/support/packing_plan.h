#pragma once

#include "support/packed_sets.h"

#include <array>
#include <optional>

namespace meshalyzer::test {

/// The places of objects on a lattice, and the pairs that meet. The objects of the lattice come
/// first, columns (x) fastest, then rows (y), then layers; those inside others follow.
struct PackingPlan {
  std::size_t n_lattice = 0;
  std::size_t n_columns = 0;
  std::size_t n_rows = 0;
  /// The pairs in order of `a`.
  std::vector<KnownPair> pairs;
  /// #lattice: the distance by which the object reaches for its neighbour along x.
  std::vector<std::optional<Relation>> reach;
  /// #lattice: 1 if another object reaches for it or is inside, and so may be the nearest to any of
  /// its vertices.
  std::vector<std::uint8_t> is_engaged;

  /// Column, row and layer.
  [[nodiscard]] std::array<std::size_t, 3> cell_of(std::size_t object) const;
  /// The object itself if it stands on the lattice, else the one that it is inside.
  [[nodiscard]] std::size_t place_of(std::size_t object) const;
  [[nodiscard]] bool has_neighbour(std::size_t object) const;
};

/// The unit that coordinates are multiples of where sums of them must not be rounded.
inline constexpr double kGrid = 1.0 / 1048576.0;

/// @throws InvalidArgument if a length or a number is out of its range.
[[nodiscard]] const PackOptions& checked(const PackOptions& options);

/// @param options       Options that checked() has accepted.
/// @param layer_height  A height in cells; the box of all objects is as near to a cube as possible.
/// @throws InvalidArgument if the lattice has fewer neighbours than are to meet, or fewer objects
/// than are to hold others.
[[nodiscard]] PackingPlan make_plan(const PackOptions& options, double layer_height);

}  // namespace meshalyzer::test
