#pragma once

#include "meshalyzer/defects/find_defects.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// How thoroughly to check (contract 5, P 86.4).
enum class CheckLevel : std::uint8_t {
  /// Nothing.
  None,
  /// Not non-manifold, no degenerate or flat facet, no opposed vertex normal; where the mesh is
  /// that of a single face of a body: not disjoint, borders matched to the polylines given.
  Basic,
  /// Also no slit and no self-intersection.
  Full,
};

/// Points along an edge of a body, in order, that the border of a face's mesh must run through.
using Polyline = std::vector<Vec3>;

struct CheckOptions {
  CheckLevel level = CheckLevel::Full;
  ToleranceOptions tolerances = {};
  /// Whether the mesh is that of a single face of a body.
  bool is_single_face = false;
  /// What the border of a single face must match; none: any border will do. Only referred to.
  std::span<const Polyline> polylines = {};
};

/// What makes a mesh invalid at a level.
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

[[nodiscard]] CheckResult check(const Soup& soup, const CheckOptions& options = {});

/// Finds the clashes between two meshes: all pairs of faces, one of each, that share a point.
///
/// @return  As find_intersections().
[[nodiscard]] std::vector<IntersectingPair> check_pair(const Soup& a, const Soup& b);

}  // namespace meshalyzer
