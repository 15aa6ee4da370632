#pragma once

#include "meshalyzer/defects/tolerances.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/driver/defect_counts.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// A defective element, named by the elements of the input that it was made of, so that those of
/// the input and of a repaired mesh can be compared.
struct CountedElement {
  CountedDefect kind = CountedDefect::BorderEdges;
  /// The identities of the vertex or of the ends of the edge (vertex_identity()), or of the face or
  /// of both faces of a pair (face_identity()), in ascending order. The second is kNoIndex if there
  /// is one only.
  std::array<Index, 2> origins{kNoIndex, kNoIndex};
  /// The same vertices or faces by index in the soup, in any order.
  std::array<Index, 2> members{kNoIndex, kNoIndex};

  friend auto operator<=>(const CountedElement& a, const CountedElement& b) {
    if (const auto order = a.kind <=> b.kind; order != 0) return order;
    return a.origins <=> b.origins;
  }
  friend bool operator==(const CountedElement& a, const CountedElement& b) {
    return (a <=> b) == 0;
  }
};

/// An attribute of a mesh, as reports state it.
enum class Attribute : std::uint8_t { Closed, Manifold, Orientable, Consistent, Outward };

inline constexpr std::size_t kAttributes = 5;

/// All defective elements of a mesh that a repair counts, and its attributes.
struct DefectInventory {
  /// In ascending order.
  std::vector<CountedElement> elements;
  /// Indexed by CountedDefect.
  std::array<std::size_t, kCountedDefects> counts{};
  /// Indexed by Attribute: whether the mesh has it.
  std::array<bool, kAttributes> is_yes{};
  /// The number of border edges with an end where a sheet was cut, and that of the edges of slits
  /// that have such an edge.
  std::size_t n_borders_of_cut_sheets = 0;
  std::size_t n_slits_of_cut_sheets = 0;

  [[nodiscard]] std::size_t count(CountedDefect kind) const {
    return counts[static_cast<std::size_t>(kind)];
  }
};

/// Tells whether faces that touch at copies of a vertex, which welding would join, count as
/// intersecting.
enum class UnweldedPairs : std::uint8_t { Count, Ignore };

/// Returns the identity of a vertex in the input: its key there, that of the vertex that it is a
/// copy of, or, for a new vertex, its own key.
[[nodiscard]] Index vertex_identity(const TrackedMesh& tracked, Index key);

/// Returns the key of the input's face that a face, by key, was made of; for a face of a hole
/// patch, its own key.
[[nodiscard]] Index face_identity(const TrackedMesh& tracked, Index key);

/// The vertices of a defective element, by identity: the vertex, the ends of the edge, or the
/// corners of each face. The rest is kNoIndex.
using ElementCorners = std::array<Triangle, 2>;

[[nodiscard]] ElementCorners corners_of(const TrackedMesh& tracked, const CountedElement& element);

/// Lists the defective elements of a mesh. Intersections, zero areas and attributes are exact.
///
/// @param mesh  Prepared from tracked.soup.
/// @complexity  O(#V + #F), and the cost of PreparedMesh::intersecting_pairs() and shells().
[[nodiscard]] DefectInventory list_defective(const TrackedMesh& tracked, const PreparedMesh& mesh,
                                             const Tolerances& tolerances, UnweldedPairs unwelded);

}  // namespace meshalyzer
