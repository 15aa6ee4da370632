#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace meshalyzer::test {

/// The relation of two objects that are not apart.
enum class Relation : std::uint8_t {
  /// Faces of the two cross, and neither object lies in the other.
  Crossing,
  /// They share points of their surfaces; nothing crosses.
  Touching,
  /// `a` lies wholly inside the solid of `b`; no face touches.
  Contained,
};

/// Two objects that are not apart, by number; a < b unless Contained.
struct KnownPair {
  Index a = 0;
  Index b = 0;
  Relation relation = Relation::Crossing;

  friend bool operator==(const KnownPair&, const KnownPair&) = default;
};

/// The distance of a vertex from the nearest point of any other object; negative inside the solid
/// of one.
struct KnownDistance {
  Index object = 0;
  Index vertex = 0;
  double distance = 0.0;
};

/// A set of objects, each good by itself, and the figures known by construction.
struct PackedSet {
  std::vector<Soup> objects;
  /// The file names, one an object, ascending.
  std::vector<std::string> names;
  /// All pairs of objects that are not apart.
  std::vector<KnownPair> pairs;
  /// Objects that are apart are no nearer to each other than this.
  double gap = 0.0;
  /// The distances of some vertices, or of all; each function says which.
  std::vector<KnownDistance> distances;
  /// The true distances exceed those given by 0 to this. 0: they are right to the last bit, unless
  /// the function mentions rounding.
  double slack = 0.0;
};

/// The set to pack. Lengths are in units of the objects' largest radius.
struct PackOptions {
  std::size_t n_objects = 27;
  /// The approximate number: the nearest that the shape permits is taken.
  std::size_t faces_per_object = 200;
  /// The distance of objects, in (0, 2]. It becomes PackedSet::gap.
  double gap = 0.25;
  std::uint32_t seed = 1;
  /// The number of neighbours that cross, the spike of one `overlap` deep in the other.
  std::size_t n_crossing = 0;
  /// The number of neighbours that touch in one point, a vertex of either.
  std::size_t n_touching = 0;
  /// The number of objects inside another one.
  std::size_t n_contained = 0;
  /// The depth of crossing spikes, in (0, 1/2]. A multiple of 2^-20 keeps them exact.
  double overlap = 0.125;
};

/// Closed tubes side by side and in layers, with dents of their own, all winding about the same
/// helix: each box overlaps those of many neighbours, though the tubes keep their distance.
///
/// `distances` holds, with exact coordinates, for most neighbours along x a vertex of one whose
/// nearest point is a vertex of the other; for touching pairs both vertices (0); and, to
/// rounding, the tips of crossing spikes and one vertex of each contained object.
///
/// @throws InvalidArgument if an option is out of its range, or the packing has not as many
/// neighbours along x as are to cross, to touch and to hold objects.
[[nodiscard]] PackedSet pack_tubes(const PackOptions& options);

/// Packs spheres with smooth dents on a cubic lattice, one an object, otherwise like pack_tubes().
/// The contained objects have no distances.
[[nodiscard]] PackedSet pack_blobs(const PackOptions& options);

/// The name of the file of one of `n` objects: its number from 1, with zeros in front, so that name
/// order is number order.
[[nodiscard]] std::string object_name(std::size_t object, std::size_t n);

}  // namespace meshalyzer::test
