#include "support/closed_form_sets.h"

#include "meshalyzer/base/error.h"
#include "support/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace meshalyzer::test {
namespace {

Index index(std::size_t i) {
  return static_cast<Index>(i);
}

Soup box(const Vec3& low, const Vec3& high) {
  Soup soup = shapes::cube();
  for (Vec3& p : soup.positions) {
    for (Eigen::Index k = 0; k < 3; ++k) p[k] = p[k] == 0 ? low[k] : high[k];
  }
  return soup;
}

/// A box about the origin.
Soup box(const Vec3& half) {
  return box(-half, half);
}

/// Adds an object; `distance` tells that of a vertex from its position.
template <typename Distance>
void add(PackedSet& set, Soup object, const Distance& distance) {
  const Index number = index(set.objects.size());
  for (std::size_t v = 0; v < object.n_vertices(); ++v) {
    set.distances.push_back({number, index(v), distance(object.positions[v])});
  }
  set.names.push_back(object_name(number, 9));
  set.objects.push_back(std::move(object));
}

/// The half widths of box_in_box(), three_deep() and object_in_cavity().
Vec3 innermost(double margin) {
  return margin * Vec3(1, 1, 1);
}
Vec3 middle(double margin) {
  return margin * Vec3(2, 3, 3);
}
Vec3 outermost(double margin) {
  return margin * Vec3(4, 7, 7);
}

/// The small box of touching_boxes() pushed in so far.
PackedSet small_box_at(double depth, std::vector<KnownPair> pairs) {
  PackedSet set;
  add(set, box({-12 - depth, 0, 0}, {0, 10, 10}),
      [](const Vec3& p) { return p.x() == 0 ? 5.0 : 13.0; });
  add(set, box({0 - depth, 3, 4}, {2, 7, 6}),
      [&](const Vec3& p) { return p.x() == 2 ? 2.0 : 0 - depth; });
  set.pairs = std::move(pairs);
  return set;
}

/// The corners of a polygon about the z axis, counter-clockwise seen from above.
using Ring = std::vector<Vec3>;

Ring polygon(double radius, double z, std::size_t n) {
  Ring ring;
  for (std::size_t j = 0; j < n; ++j) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
    ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return ring;
}

Ring square(double half, double z) {
  return {{half, -half, z}, {half, half, z}, {-half, half, z}, {-half, -half, z}};
}

/// Joins each of several rings of n vertices to the next one, and the last to the first: up on the
/// outside, and down in the bore.
Soup joined(const std::vector<Ring>& rings) {
  Soup soup;
  const std::size_t m = rings.size();
  const std::size_t n = rings.front().size();
  const auto at = [&](std::size_t ring, std::size_t j) { return index(ring % m * n + j % n); };
  for (const Ring& ring : rings) {
    soup.positions.insert(soup.positions.end(), ring.begin(), ring.end());
  }
  for (std::size_t ring = 0; ring < m; ++ring) {
    for (std::size_t j = 0; j < n; ++j) {
      soup.triangles.push_back({at(ring, j), at(ring, j + 1), at(ring + 1, j + 1)});
      soup.triangles.push_back({at(ring, j), at(ring + 1, j + 1), at(ring + 1, j)});
    }
  }
  return soup;
}

/// A prism whose first 2n vertices are its corners, followed by the middles of its ends.
Soup prism(double radius, std::size_t n) {
  Soup soup = joined({polygon(radius, -1, n), polygon(radius, 1, n)});
  // The surface does not go back down from the upper ring to the lower one.
  soup.triangles.resize(2 * n);
  soup.positions.emplace_back(0, 0, -1);
  soup.positions.emplace_back(0, 0, 1);
  for (std::size_t j = 0; j < n; ++j) {
    const std::size_t next = (j + 1) % n;
    soup.triangles.push_back({index(2 * n), index(next), index(j)});
    soup.triangles.push_back({index(2 * n + 1), index(n + j), index(n + next)});
  }
  return soup;
}

/// Returns the distance of the nearest facet of a sphere about the origin from it.
double inradius(const Soup& sphere) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : sphere.triangles) {
    const Vec3& p = sphere.positions[a];
    const Vec3 normal = (sphere.positions[b] - p).cross(sphere.positions[c] - p).normalized();
    least = std::min(least, normal.dot(p));
  }
  return least;
}

/// How two spheres lie, of which the facets have the radii `inner` times the given ones.
std::vector<KnownPair> relation(const SpherePair& s, double inner) {
  const double d = s.distance;
  const double inner_a = s.radius_a * inner;
  const double inner_b = s.radius_b * inner;
  if (d > s.radius_a + s.radius_b) return {};
  if (d + s.radius_b < inner_a) return {{1, 0, Relation::Contained}};
  if (d + s.radius_a < inner_b) return {{0, 1, Relation::Contained}};
  const bool is_neither_inside = d + inner_b > s.radius_a && d + inner_a > s.radius_b;
  if (d < inner_a + inner_b && is_neither_inside) return {{0, 1, Relation::Crossing}};
  throw InvalidArgument("too near to touching to tell how the spheres lie");
}

}  // namespace

PackedSet parallel_plates(double gap) {
  PackedSet set;
  add(set, box({0, 0, -1}, {4, 4, 0}), [&](const Vec3& p) { return p.z() == 0 ? gap : gap + 1; });
  add(set, box({0, 0, gap}, {4, 4, gap + 1}),
      [&](const Vec3& p) { return p.z() == gap ? gap : gap + 1; });
  set.gap = gap;
  return set;
}

PackedSet box_in_box(double margin) {
  PackedSet set;
  add(set, box(innermost(margin)), [&](const Vec3&) { return -margin; });
  add(set, box(middle(margin)), [&](const Vec3&) { return 3 * margin; });
  set.pairs = {{0, 1, Relation::Contained}};
  return set;
}

PackedSet three_deep(double margin) {
  PackedSet set;
  add(set, box(innermost(margin)), [&](const Vec3&) { return -margin; });
  add(set, box(middle(margin)), [&](const Vec3&) { return -2 * margin; });
  add(set, box(outermost(margin)), [&](const Vec3&) { return 6 * margin; });
  set.pairs = {
      {0, 1, Relation::Contained}, {0, 2, Relation::Contained}, {1, 2, Relation::Contained}};
  return set;
}

PackedSet object_in_cavity(double margin) {
  const Soup wall = shapes::flipped(box(middle(margin)));
  PackedSet set;
  add(set, box(innermost(margin)), [&](const Vec3&) { return margin; });
  add(set, shapes::merged(box(outermost(margin)), wall), [&](const Vec3& p) {
    return std::abs(p.x()) == middle(margin).x() ? 3 * margin : 9 * margin;
  });
  set.gap = margin;
  return set;
}

PackedSet touching_boxes() {
  return small_box_at(0, {{0, 1, Relation::Touching}});
}

PackedSet crossing_boxes() {
  return small_box_at(1, {{0, 1, Relation::Crossing}});
}

PackedSet rod_in_square_tube(double gap) {
  PackedSet set;
  add(set, box(gap * Vec3(1, 1, 3.5)), [&](const Vec3&) { return gap; });
  add(set,
      joined({square(7 * gap, -4 * gap), square(7 * gap, 4 * gap), square(2 * gap, 4 * gap),
              square(2 * gap, -4 * gap)}),
      [&](const Vec3& p) { return std::abs(p.x()) == 2 * gap ? 1.5 * gap : 8.5 * gap; });
  set.gap = gap;
  return set;
}

PackedSet rod_in_round_tube(const RoundTube& tube) {
  const std::size_t n = tube.n_sides;
  if (n < 3 || !(0 < tube.rod_radius && tube.rod_radius < tube.bore_radius &&
                 tube.bore_radius < tube.outer_radius)) {
    throw InvalidArgument("the radii of a tube must ascend, and it needs three sides");
  }
  const double slant = std::cos(std::numbers::pi / static_cast<double>(n));
  PackedSet set;
  add(set, prism(tube.rod_radius, n), [&](const Vec3& p) {
    const bool is_middle = p.x() == 0 && p.y() == 0;
    return slant * (is_middle ? tube.bore_radius : tube.bore_radius - tube.rod_radius);
  });
  add(set,
      joined({polygon(tube.outer_radius, -1, n), polygon(tube.outer_radius, 1, n),
              polygon(tube.bore_radius, 1, n), polygon(tube.bore_radius, -1, n)}),
      [&](const Vec3& p) { return std::hypot(p.x(), p.y()) - tube.rod_radius; });
  set.gap = slant * (tube.bore_radius - tube.rod_radius);
  return set;
}

PackedSet two_spheres(const SpherePair& spheres) {
  if (!(spheres.radius_a > 0 && spheres.radius_b > 0 && spheres.distance > 0)) {
    throw InvalidArgument("lengths must be positive");
  }
  const Soup unit = shapes::icosphere(spheres.level);
  const double inner = inradius(unit);
  const Vec3 centre_a = Vec3::Zero();
  const Vec3 centre_b(spheres.distance, 0, 0);
  PackedSet set;
  add(set, shapes::scaled(unit, spheres.radius_a),
      [&](const Vec3& p) { return (p - centre_b).norm() - spheres.radius_b; });
  add(set, shapes::translated(shapes::scaled(unit, spheres.radius_b), centre_b),
      [&](const Vec3& p) { return (p - centre_a).norm() - spheres.radius_a; });
  set.pairs = relation(spheres, inner);
  set.gap = std::max(0.0, spheres.distance - spheres.radius_a - spheres.radius_b);
  set.slack = std::max(spheres.radius_a, spheres.radius_b) * (1 - inner);
  return set;
}

}  // namespace meshalyzer::test
