#include "meshalyzer/defects/check.h"

#include "meshalyzer/base/require.h"
#include "meshalyzer/mesh/finite_positions.h"
#include "meshalyzer/spatial/mutual_intersection.h"
#include "meshalyzer/spatial/segment_grid.h"
#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <array>

namespace meshalyzer {
namespace {

DefectCodes codes_of(const CheckOptions& options) {
  DefectCodes codes{DefectCode::Corrupt, DefectCode::NonManifold, DefectCode::DegenerateFacet,
                    DefectCode::FlatFacet, DefectCode::VertexNormal};
  if (options.is_single_face) codes.insert(DefectCode::Disjoint);
  if (options.level == CheckLevel::Full) {
    codes.insert(DefectCode::Slit);
    codes.insert(DefectCode::SelfIntersection);
  }
  return codes;
}

/// Returns the border edges of a mesh by their file vertices, the smaller first.
std::vector<std::array<Index, 2>> border_edge_ends(const CutMesh& cut) {
  std::vector<std::array<Index, 2>> edges;
  for (const HalfedgeHandle h : find_border_edges(cut)) {
    edges.push_back(ascending_file_ends(cut, h));
  }
  return edges;
}

/// Returns the segments of all polylines except those of length 0, which have no direction.
std::vector<Segment> segments_of(std::span<const Polyline> polylines) {
  std::vector<Segment> segments;
  for (const Polyline& line : polylines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      if (line[i - 1] != line[i]) segments.push_back({line[i - 1], line[i]});
    }
  }
  return segments;
}

/// Finds the segments that lie on none of the others.
///
/// @return Their numbers, ascending.
std::vector<Index> find_unmatched(std::span<const Segment> segments,
                                  std::span<const Segment> others, double tolerance) {
  const SegmentGrid grid(others, tolerance);
  std::vector<Index> unmatched;
  for (Index i = 0; i < segments.size(); ++i) {
    bool is_matched = false;
    grid.visit_near(segments[i], [&](Index j) {
      is_matched = is_matched || gap_between(segments[i], others[j]) <= tolerance;
    });
    if (!is_matched) unmatched.push_back(i);
  }
  return unmatched;
}

void match_borders(const PreparedMesh& mesh, std::span<const Polyline> polylines,
                   CheckResult& result) {
  const double tolerance = result.report.tolerances.slit;
  const std::vector<Segment> segments = segments_of(polylines);
  const std::vector<std::array<Index, 2>> edges = border_edge_ends(mesh.cut());
  std::vector<Segment> places;
  for (const auto& [a, b] : edges) {
    places.push_back({mesh.soup().positions[a], mesh.soup().positions[b]});
  }
  for (const Index i : find_unmatched(segments, places, tolerance)) {
    result.unmatched_segments.push_back(segments[i]);
  }
  for (const Index i : find_unmatched(places, segments, tolerance)) {
    result.unmatched_border_edges.push_back(edges[i]);
  }
}

}  // namespace

CheckResult check(const Soup& soup, const CheckOptions& options) {
  for (const Polyline& line : options.polylines) {
    for (const Vec3& point : line) require_point("a point of a polyline", point);
  }
  CheckResult result;
  if (options.level == CheckLevel::None) return result;
  const PreparedMesh mesh(soup);
  result.report =
      find_defects(mesh, {.codes = codes_of(options), .tolerances = options.tolerances});
  if (options.is_single_face && !options.polylines.empty() && has_finite_positions(soup)) {
    match_borders(mesh, options.polylines, result);
  }
  return result;
}

std::vector<IntersectingPair> check_pair(const Soup& a, const Soup& b) {
  const PreparedMesh mesh_a(a);
  const PreparedMesh mesh_b(b);
  return find_intersections(mesh_a.cut(), mesh_a.tree(), mesh_b.cut(), mesh_b.tree());
}

}  // namespace meshalyzer
