#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/repair/edits/edits.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// The numbers by which surfaces with the same border differ if their topology does.
struct SurfaceTopology {
  /// V - E + F.
  std::ptrdiff_t euler_characteristic = 0;
  /// The number of components, connected through edges.
  std::size_t components = 0;
  /// Tells whether no edge has more than two faces.
  bool is_manifold = true;

  friend bool operator==(const SurfaceTopology&, const SurfaceTopology&) = default;
};

/// @complexity  O(n log n).
[[nodiscard]] SurfaceTopology topology_of(std::span<const Triangle> faces);

/// Finds the faces that edits exchange for surfaces of the same topology, operation by operation.
///
/// @return      #faces: 1 for those.
/// @complexity  O(#F + n log n), n the number of faces removed and added.
[[nodiscard]] std::vector<std::uint8_t> faces_replaced_alike(const Soup& soup, const Edits& edits);

}  // namespace meshalyzer
