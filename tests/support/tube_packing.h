#pragma once

#include "support/packing_plan.h"

#include <array>

namespace meshalyzer::test {

/// Makes the tubes of pack_tubes() one at a time, so that a large set need not be in memory.
///
/// Why the gap holds: take straight upright prisms inscribed in circles of radius 1, on a lattice
/// so wide that they are `clearance` apart, and move each horizontal plane by the offset of the
/// helix at its height, which is linear between one ring of vertices and the next. In every slab
/// that is a shear by a slope of at most L, whose inverse stretches nothing by more than s = (L +
/// sqrt(L^2 + 4)) / 2. So no two tubes are nearer than clearance / s. Dents only take away.
///
/// Where it is attained: about the middle of each layer is a band where the helix rests and no tube
/// has a dent. The vertex of a tube that faces its neighbour along x is there exactly `clearance`
/// from the neighbour's, and nothing outside the band is as near, for the band is higher than that.
/// All coordinates that matter are multiples of 2^-20, so nothing is rounded.
class TubePacking {
 public:
  /// @throws InvalidArgument as pack_tubes() does.
  explicit TubePacking(const PackOptions& options);

  [[nodiscard]] const PackingPlan& plan() const { return plan_; }
  [[nodiscard]] Soup object(std::size_t i) const;
  /// The distances as PackedSet::distances has them.
  [[nodiscard]] std::vector<KnownDistance> distances() const;

 private:
  /// The rings of one tube, by number among those of all layers.
  struct Rings {
    std::size_t first = 0;
    std::size_t count = 0;
    std::size_t middle = 0;
  };

  void wind();
  [[nodiscard]] Rings rings_of(std::size_t object) const;
  [[nodiscard]] std::size_t middle_of_layer(std::size_t layer) const;
  [[nodiscard]] Index facing_right(std::size_t object) const;
  [[nodiscard]] Index facing_left(std::size_t object) const;

  PackOptions options_;
  std::size_t n_spokes_ = 0;
  std::size_t n_rings_ = 0;
  /// The number of rings by which a tube may begin later than others of its layer.
  std::size_t shift_ = 0;
  /// The number of rings on either side of a layer's middle where the helix rests.
  std::size_t band_ = 0;
  /// The number of rings from one layer to the next.
  std::size_t layer_ = 0;
  double height_of_ring_ = 0.0;
  double clearance_ = 0.0;
  PackingPlan plan_;
  /// The position of the axis of a tube at the origin, indexed by ring.
  std::vector<Vec3> axis_;
};

}  // namespace meshalyzer::test
