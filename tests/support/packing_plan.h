#pragma once

#include "support/packed_sets.h"

#include <array>
#include <optional>

namespace meshalyzer::test {

/// Which object stands where on a lattice, and which ones meet. The objects of the lattice come
/// first, columns (x) fastest, then rows (y), then layers; behind them the ones inside others.
struct PackingPlan {
  std::size_t n_lattice = 0;
  std::size_t n_columns = 0;
  std::size_t n_rows = 0;
  /// In order of `a`.
  std::vector<KnownPair> pairs;
  /// #lattice: how far the object reaches for its neighbour along x.
  std::vector<std::optional<Relation>> reach;
  /// #lattice: 1 where another object reaches for it or is inside, and so may be what is nearest to
  /// any of its vertices.
  std::vector<std::uint8_t> is_engaged;

  /// Column, row and layer.
  [[nodiscard]] std::array<std::size_t, 3> cell_of(std::size_t object) const;
  /// The object itself where it stands on the lattice, else the one that it is inside.
  [[nodiscard]] std::size_t place_of(std::size_t object) const;
  [[nodiscard]] bool has_neighbour(std::size_t object) const;
};

/// What coordinates are multiples of, where sums of them must not be rounded.
inline constexpr double kGrid = 1.0 / 1048576.0;

/// @throws InvalidArgument if a length or a number is out of its range.
[[nodiscard]] const PackOptions& checked(const PackOptions& options);

/// @param options       As checked() lets through.
/// @param layer_height  In cells; the box of all objects is as near to a cube as may be.
/// @throws InvalidArgument if the lattice has not as many neighbours as are to meet, or objects as
/// are to hold others.
[[nodiscard]] PackingPlan make_plan(const PackOptions& options, double layer_height);

}  // namespace meshalyzer::test
