#pragma once

#include "support/packed_sets.h"

#include <cstddef>

/// Small sets whose distances are known from a formula: those of all vertices unless stated
/// otherwise.
///
/// A length given should be a small multiple of a power of two: then nothing is rounded, neither in
/// the coordinates, nor in their differences, the sums of their squares, or the roots of these.
namespace meshalyzer::test {

/// Two boxes of 4 x 4 x 1, face to face `gap` apart: `gap` from the vertices that face the other
/// box, gap + 1 from those behind.
[[nodiscard]] PackedSet parallel_plates(double gap);

/// A cube of side 2 margin in a box that leaves `margin` on the left and right of it and 2 margin
/// on the other sides: contained. -margin from its vertices, 3 margin from those of the box, for 1
/// + 2^2 + 2^2 = 3^2.
[[nodiscard]] PackedSet box_in_box(double margin);

/// box_in_box(), and round it a third box that leaves 2 margin and 4 margin: three contained pairs.
/// -margin from the innermost vertices, -2 margin from the middle ones, 6 margin from the
/// outermost.
[[nodiscard]] PackedSet three_deep(double margin);

/// The cube of box_in_box() as a guest in a cavity as large as the box, in a host as large as the
/// third of three_deep(): apart, not contained. margin from the guest's vertices; 3 margin from
/// those of the cavity, 9 margin from the outer ones of the host, for 3^2 + 6^2 + 6^2 = 9^2.
[[nodiscard]] PackedSet object_in_cavity(double margin);

/// A box of 2 x 4 x 2 stands with its left side amid the right one of a box of 12 x 10 x 10. 0 and
/// 2 from its vertices; 5 from the right ones of the large box, 13 from the left ones, for 3^2 +
/// 4^2 = 5^2 and 12^2 + 5^2 = 13^2.
[[nodiscard]] PackedSet touching_boxes();

/// touching_boxes() with the small box pushed in by 1 and longer by 1, as is the large one: -1 and
/// 2 from its vertices, 5 and 13 from those of the large box.
[[nodiscard]] PackedSet crossing_boxes();

/// A square tube and a square rod in its bore, `gap` from all its walls: not contained.
///
/// The rod is 2 gap wide and 7 gap long, the bore 4 gap wide, the tube 14 gap wide and 8 gap long.
/// So the rim of the bore is (1, 1, 1/2) gap from the rod's corners, at a distance of 3/2 gap, and
/// the outer corners of the tube (6, 6, 1/2) gap, at 17/2 gap. gap from the rod's vertices.
[[nodiscard]] PackedSet rod_in_square_tube(double gap);

/// The shape of a tube of rod_in_round_tube().
struct RoundTube {
  /// The number of sides of the tube and of the rod, at least 3.
  std::size_t n_sides = 16;
  double rod_radius = 1.0;
  double bore_radius = 1.5;
  double outer_radius = 2.0;
};

/// A prism of n sides in the bore of a tube of n sides, edge to edge, their ends flush. The radii
/// are those of the edges, so the vertices of the rod are (bore_radius - rod_radius) cos(pi / n)
/// from the facets of the bore, the middles of its ends bore_radius cos(pi / n). A vertex of the
/// tube is nearest to the vertex of the rod in the same direction: the difference of their radii.
/// All this to rounding.
///
/// @throws InvalidArgument if there are fewer than three sides, or the radii do not ascend from 0.
[[nodiscard]] PackedSet rod_in_round_tube(const RoundTube& tube);

/// The input of two_spheres(); the second sphere is `distance` away along x.
struct SpherePair {
  double radius_a = 1.0;
  double radius_b = 1.0;
  double distance = 3.0;
  /// The subdivision level of shapes::icosphere().
  std::size_t level = 3;
};

/// Two spheres of triangles, which may be apart, cross, or be one in the other.
///
/// A sphere of triangles with the radius r lies between the spheres of radius r and i, where i is
/// the distance of its nearest facet from the centre c. So a point p is between |p - c| - r and |p
/// - c| - i from it, negative inside; `distances` are the lower bounds, `slack` the largest
/// difference between the two.
///
/// @throws InvalidArgument if a length is not positive, or the spheres are so placed that these
/// bounds do not tell how they lie.
[[nodiscard]] PackedSet two_spheres(const SpherePair& spheres);

}  // namespace meshalyzer::test
