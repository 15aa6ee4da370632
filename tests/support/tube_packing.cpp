#include "support/tube_packing.h"

#include "support/constants.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace meshalyzer::test {
namespace {

constexpr double kLength = 20.0;
constexpr double kHelixRadius = 3.0;
/// Of the helix, where it does not rest: it turns once along a tube's length.
constexpr double kSlope = 2 * kPi * kHelixRadius / kLength;
constexpr double kDeepestTubeDent = 0.4;
/// A tube inside another one; that one's axis is more than (1 - kDeepestTubeDent) / sqrt(2) = 0.42
/// from its surface.
constexpr double kInnerTubeRadius = 0.25;

double real(std::size_t i) {
  return static_cast<double>(i);
}

double on_grid(double x) {
  return std::round(x / kGrid) * kGrid;
}

/// A point of the unit circle; exact at the quarters, which sine and cosine are not.
Vec3 on_circle(std::size_t spoke, std::size_t n_spokes) {
  const std::array<Vec3, 4> quarters{
      {Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitX(), -Vec3::UnitY()}};
  if (4 * spoke % n_spokes == 0) return quarters[4 * spoke / n_spokes];
  const double angle = 2 * kPi * real(spoke) / real(n_spokes);
  return {std::cos(angle), std::sin(angle), 0.0};
}

/// The depth of the dents of a tube, 0 ... 1: two waves that run round it and along.
class Dents {
 public:
  explicit Dents(std::uint32_t seed) {
    std::mt19937 random(seed);
    for (double& phase : phases_) phase = 2 * kPi * static_cast<double>(random()) / 4294967296.0;
  }
  [[nodiscard]] double at(double angle, double height) const {
    return (2 + std::sin(2 * angle + height + phases_[0]) +
            std::sin(3 * angle - 0.7 * height + phases_[1])) /
           4;
  }

 private:
  std::array<double, 2> phases_{};
};

/// Joins rings of vertices, bottom to top, and closes both ends with a fan round a vertex of its
/// own.
void add_faces(Soup& soup, std::size_t n_rings, std::size_t n_spokes) {
  const auto at = [&](std::size_t ring, std::size_t spoke) {
    return static_cast<Index>(ring * n_spokes + spoke % n_spokes);
  };
  const Index bottom = at(n_rings, 0);
  const Index top = bottom + 1;
  soup.triangles.reserve(2 * n_rings * n_spokes);
  for (std::size_t j = 0; j < n_spokes; ++j) {
    soup.triangles.push_back({bottom, at(0, j + 1), at(0, j)});
    soup.triangles.push_back({top, at(n_rings - 1, j), at(n_rings - 1, j + 1)});
  }
  for (std::size_t k = 0; k + 1 < n_rings; ++k) {
    for (std::size_t j = 0; j < n_spokes; ++j) {
      soup.triangles.push_back({at(k, j), at(k, j + 1), at(k + 1, j + 1)});
      soup.triangles.push_back({at(k, j), at(k + 1, j + 1), at(k + 1, j)});
    }
  }
}

}  // namespace

TubePacking::TubePacking(const PackOptions& options) : options_(checked(options)) {
  // The numbers of rings and spokes make edges of about equal length; #F = 2 rings spokes.
  const double faces = real(options.faces_per_object);
  const double spokes = std::round(std::sqrt(faces * kPi / kLength) / 4);
  n_spokes_ = 4 * static_cast<std::size_t>(std::max(1.0, spokes));
  n_rings_ = static_cast<std::size_t>(std::max(5.0, std::round(faces / real(2 * n_spokes_))));
  shift_ = n_rings_ / 8;
  height_of_ring_ = on_grid(kLength / real(n_rings_ - 1));

  // The offsets of the helix are rounded to the grid, which may make it a little steeper.
  const double slope = kSlope + 2 * kGrid / height_of_ring_;
  const double stretch = (slope + std::sqrt(slope * slope + 4)) / 2;
  clearance_ = std::ceil(options.gap * stretch * (1 + 1e-9) / kGrid) * kGrid;
  band_ = static_cast<std::size_t>(std::ceil(std::max(clearance_, 1.0) / height_of_ring_));
  const auto between = static_cast<std::size_t>(std::ceil(clearance_ / height_of_ring_));
  layer_ = n_rings_ - 1 + shift_ + between;
  plan_ = make_plan(options, real(layer_) * height_of_ring_ / (2 + clearance_));
  wind();
}

void TubePacking::wind() {
  const std::size_t n_layers = plan_.cell_of(plan_.n_lattice - 1)[2] + 1;
  double wound = 0.0;
  for (std::size_t k = 0; k < n_layers * layer_; ++k) {
    const double angle = 2 * kPi * wound / kLength;
    axis_.emplace_back(on_grid(kHelixRadius * std::cos(angle)),
                       on_grid(kHelixRadius * std::sin(angle)), real(k) * height_of_ring_);
    const std::size_t middle = middle_of_layer(k / layer_);
    const bool rests = k + band_ >= middle && k < middle + band_;
    if (!rests) wound += height_of_ring_;
  }
}

std::size_t TubePacking::middle_of_layer(std::size_t layer) const {
  return layer * layer_ + (n_rings_ - 1 + shift_) / 2;
}

TubePacking::Rings TubePacking::rings_of(std::size_t object) const {
  const std::size_t place = plan_.place_of(object);
  const std::size_t layer = plan_.cell_of(place)[2];
  std::mt19937 random(options_.seed + static_cast<std::uint32_t>(place));
  const std::size_t first = layer * layer_ + random() % (shift_ + 1);
  const std::size_t inset = object == place ? 0 : 1;
  return {first + inset, n_rings_ - 2 * inset, middle_of_layer(layer)};
}

Index TubePacking::facing_right(std::size_t object) const {
  const Rings rings = rings_of(object);
  return static_cast<Index>((rings.middle - rings.first) * n_spokes_);
}

Index TubePacking::facing_left(std::size_t object) const {
  return facing_right(object) + static_cast<Index>(n_spokes_ / 2);
}

Soup TubePacking::object(std::size_t i) const {
  const std::size_t place = plan_.place_of(i);
  const auto cell = plan_.cell_of(place);
  const double pitch = 2 + clearance_;
  const Vec3 foot(real(cell[0]) * pitch, real(cell[1]) * pitch, 0.0);
  const Dents dents(options_.seed + static_cast<std::uint32_t>(i));
  const Rings rings = rings_of(i);

  Soup soup;
  soup.positions.reserve(rings.count * n_spokes_ + 2);
  for (std::size_t k = rings.first; k < rings.first + rings.count; ++k) {
    const std::size_t off = std::max(k, rings.middle) - std::min(k, rings.middle);
    const double outside = off > band_ ? real(off - band_) * height_of_ring_ : 0.0;
    for (std::size_t j = 0; j < n_spokes_; ++j) {
      const double dent =
          std::min(outside, 1.0) * dents.at(2 * kPi * real(j) / real(n_spokes_), axis_[k].z());
      const double radius = i == place ? 1 - kDeepestTubeDent * dent : kInnerTubeRadius;
      soup.positions.emplace_back(foot + axis_[k] + radius * on_circle(j, n_spokes_));
    }
  }
  soup.positions.emplace_back(foot + axis_[rings.first]);
  soup.positions.emplace_back(foot + axis_[rings.first + rings.count - 1]);
  add_faces(soup, rings.count, n_spokes_);

  // A spike: the vertex that faces the neighbour, moved to its facing vertex or beyond.
  if (i == place && plan_.reach[i]) {
    const bool crosses = *plan_.reach[i] == Relation::Crossing;
    soup.positions[facing_right(i)].x() += clearance_ + (crosses ? options_.overlap : 0.0);
  }
  return soup;
}

std::vector<KnownDistance> TubePacking::distances() const {
  // The facets of a prism of n sides are inclined by pi / n to the normal of the edge between them,
  // so a point at a depth d below that edge is d cos(pi / n) from them.
  const double slant = std::cos(kPi / real(n_spokes_));
  std::vector<KnownDistance> known;
  for (std::size_t i = 0; i < options_.n_objects; ++i) {
    const auto object = static_cast<Index>(i);
    const std::size_t place = plan_.place_of(i);
    if (i != place) {
      known.push_back({object, facing_right(i), (kInnerTubeRadius - 1) * slant});
    } else if (plan_.reach[i] == Relation::Touching) {
      known.push_back({object, facing_right(i), 0.0});
      known.push_back({object + 1, facing_left(i + 1), 0.0});
    } else if (plan_.reach[i] == Relation::Crossing) {
      known.push_back({object, facing_right(i), -options_.overlap * slant});
    } else if (plan_.has_neighbour(i) && plan_.is_engaged[i] == 0) {
      known.push_back({object, facing_right(i), clearance_});
    }
  }
  return known;
}

PackedSet pack_tubes(const PackOptions& options) {
  const TubePacking packing(options);
  PackedSet set;
  for (std::size_t i = 0; i < options.n_objects; ++i) {
    set.objects.push_back(packing.object(i));
    set.names.push_back(object_name(i, options.n_objects));
  }
  set.pairs = packing.plan().pairs;
  set.gap = options.gap;
  set.distances = packing.distances();
  return set;
}

}  // namespace meshalyzer::test
