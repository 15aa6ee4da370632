#include "support/packing_plan.h"
#include "support/shapes.h"

#include <cmath>
#include <random>

namespace meshalyzer::test {
namespace {

/// Bumps stay between these radii. A ball of (1 - kDeepestDent) times the inradius of the
/// icosahedron, 0.55, is inside every blob: room for one of kInnerRadius.
constexpr double kDeepestDent = 0.3;
constexpr double kInnerRadius = 0.25;
/// The two vertices of shapes::icosphere() on its axis.
constexpr Index kRight = 0;
constexpr Index kLeft = 1;

/// The level whose 20 4^level faces are nearest to `faces` in ratio.
std::size_t level_for(std::size_t faces) {
  std::size_t level = 0;
  while (level < 12 && (std::size_t{40} << (2 * level)) <= faces) ++level;
  return level;
}

/// A sphere of radius 1 about the origin with its axis along x, dented everywhere but at its poles.
Soup dented(Soup sphere, std::uint32_t seed) {
  std::mt19937 random(seed);
  const double phase = static_cast<double>(random()) / 4294967296.0 * 6.0;
  for (Vec3& p : sphere.positions) {
    const Vec3 at(p.z(), p.x(), p.y());
    const double away_from_poles = at.y() * at.y() + at.z() * at.z();
    const double wave =
        (2.1 + std::sin(4 * at.y() + 3 * at.x() + phase) + std::sin(5 * at.z() - 2 * phase)) / 4.1;
    p = at * (1 - kDeepestDent * away_from_poles * wave);
  }
  return sphere;
}

/// Lets a pole reach a distance further.
void stretch_right(Soup& blob, double by) {
  blob.positions[kRight].x() += by;
}

}  // namespace

PackedSet pack_blobs(const PackOptions& options) {
  const PackingPlan plan = make_plan(checked(options), 1.0);
  const Soup sphere = shapes::icosphere(level_for(options.faces_per_object));
  // All vertices of a blob are within the unit ball about the middle of its cell, and so is the
  // rest of it; but for the poles by much more than rounding. The poles that face each other are on
  // one line with the middles: they are exactly `clearance` apart.
  const double clearance = std::ceil(options.gap / kGrid) * kGrid;
  const double pitch = 2 + clearance;

  PackedSet set;
  for (std::size_t i = 0; i < options.n_objects; ++i) {
    const auto [column, row, layer] = plan.cell_of(plan.place_of(i));
    const Vec3 middle = pitch * Vec3(static_cast<double>(column), static_cast<double>(row),
                                     static_cast<double>(layer));
    const bool is_inner = i >= plan.n_lattice;
    Soup blob = dented(sphere, options.seed + static_cast<std::uint32_t>(i));
    if (is_inner) blob = shapes::scaled(std::move(blob), kInnerRadius);
    blob = shapes::translated(std::move(blob), middle);
    const auto object = static_cast<Index>(i);
    if (!is_inner && plan.reach[i] == Relation::Crossing) {
      stretch_right(blob, clearance + options.overlap);
    } else if (!is_inner && plan.reach[i] == Relation::Touching) {
      stretch_right(blob, clearance);
      set.distances.push_back({object, kRight, 0.0});
      set.distances.push_back({object + 1, kLeft, 0.0});
    } else if (!is_inner && plan.has_neighbour(i) && plan.is_engaged[i] == 0) {
      set.distances.push_back({object, kRight, clearance});
    }
    set.objects.push_back(std::move(blob));
    set.names.push_back(object_name(i, options.n_objects));
  }
  set.pairs = plan.pairs;
  set.gap = options.gap;
  return set;
}

}  // namespace meshalyzer::test
