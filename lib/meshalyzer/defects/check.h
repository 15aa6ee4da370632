#pragma once

#include "meshalyzer/defects/find_defects.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// The thoroughness of check(); doc/defects.md has a table of the levels.
enum class CheckLevel : std::uint8_t {
  /// Every mesh is valid.
  None,
  /// The data must make a mesh, which is manifold and has no degenerate or flat facet and no
  /// opposed vertex normal. That of a single face of a body must also be in one piece, and its
  /// border must match the polylines that are given.
  Basic,
  /// The mesh must also have no slit and no self-intersection.
  Full,
};

/// Points along an edge of a body, in order, that the border of a face's mesh must run through.
/// They are finite.
using Polyline = std::vector<Vec3>;

/// The options of check().
struct CheckOptions {
  CheckLevel level = CheckLevel::Full;
  ToleranceOptions tolerances = {};
  /// Tells whether the mesh is that of a single face of a body.
  bool is_single_face = false;
  /// The polylines that the border of a single face must match; if there are none, any border is
  /// accepted. The caller keeps them.
  std::span<const Polyline> polylines = {};
};

/// The result of check(): what makes a mesh invalid at the requested level.
struct CheckResult {
  DefectReport report;
  /// Segments of polylines that no border edge matches within the slit tolerance, and border edges
  /// that match no segment.
  std::vector<std::array<Vec3, 2>> unmatched_segments;
  std::vector<std::array<Index, 2>> unmatched_border_edges;

  [[nodiscard]] bool is_valid() const {
    return report.total() == 0 && unmatched_segments.empty() && unmatched_border_edges.empty();
  }
};

/// Checks a mesh. The border of one with a position that is not finite, which is corrupt, is not
/// matched with polylines.
///
/// @throws InvalidArgument  as find_defects(); and if a point of a polyline is not finite.
[[nodiscard]] CheckResult check(const Soup& soup, const CheckOptions& options = {});

/// Finds the clashes between two meshes: all pairs of faces, one of each, that share a point.
///
/// Where both bound solids, make_disjoint() in meshalyzer/boolean mends them: it gives what they
/// have in common to the first. combine_solids() makes one solid of both.
///
/// @return  The same as find_intersections().
/// @throws InvalidArgument  as build(); and if a position is not finite.
[[nodiscard]] std::vector<IntersectingPair> check_pair(const Soup& a, const Soup& b);

}  // namespace meshalyzer
