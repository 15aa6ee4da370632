#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace meshalyzer::test {

/// How two objects lie to each other that are not apart.
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

/// How far a vertex is from the nearest point of any other object; negative inside the solid of
/// one.
struct KnownDistance {
  Index object = 0;
  Index vertex = 0;
  double distance = 0.0;
};

/// A set of objects, each good by itself, and what is true of it by construction.
struct PackedSet {
  std::vector<Soup> objects;
  /// One file name an object, ascending.
  std::vector<std::string> names;
  /// All pairs of objects that are not apart.
  std::vector<KnownPair> pairs;
  /// Objects that are apart are no nearer to each other than this.
  double gap = 0.0;
  /// Of some vertices, or of all: each function says which.
  std::vector<KnownDistance> distances;
  /// The true distances are those given plus something from 0 to this. 0: they are right to the
  /// last bit, where the function does not speak of rounding.
  double slack = 0.0;
};

/// What to pack. Lengths are in the objects' largest radius.
struct PackOptions {
  std::size_t n_objects = 27;
  /// About: the nearest number that the shape allows.
  std::size_t faces_per_object = 200;
  /// In (0, 2]. PackedSet::gap will be this.
  double gap = 0.25;
  std::uint32_t seed = 1;
  /// How many neighbours cross, the spike of one `overlap` deep in the other.
  std::size_t n_crossing = 0;
  /// How many neighbours touch in one point, a vertex of either.
  std::size_t n_touching = 0;
  /// How many of the objects lie inside another one.
  std::size_t n_contained = 0;
  /// In (0, 1/2]. A multiple of 2^-20 keeps the crossing spikes exact.
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

/// Spheres with smooth dents on a cubic lattice, one an object, else as pack_tubes(). Of the
/// contained objects no distances are given.
[[nodiscard]] PackedSet pack_blobs(const PackOptions& options);

/// The name of the file of one of `n` objects: its number from 1, with zeros in front, so that name
/// order is number order.
[[nodiscard]] std::string object_name(std::size_t object, std::size_t n);

}  // namespace meshalyzer::test
