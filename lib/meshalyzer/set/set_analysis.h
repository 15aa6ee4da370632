#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/base/statistics.h"
#include "meshalyzer/base/types.h"
#include "meshalyzer/set/separation.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {

/// Two faces of different meshes that share a point; mesh_a < mesh_b. Meshes are given by their
/// number in the set, faces by id.
struct SetPair {
  Index mesh_a = 0;
  std::int64_t face_a = 0;
  Index mesh_b = 0;
  std::int64_t face_b = 0;
  ContactKind kind = ContactKind::Touching;

  friend bool operator==(const SetPair&, const SetPair&) = default;
};

/// Two meshes whose faces share a point, and the number of such pairs of faces; mesh_a < mesh_b.
struct MeshMeeting {
  Index mesh_a = 0;
  Index mesh_b = 0;
  ContactCounts pairs;
};

/// A mesh inside another one whose faces it does not cross.
struct ContainedMesh {
  Index inner = 0;
  Index outer = 0;

  friend auto operator<=>(const ContainedMesh&, const ContainedMesh&) = default;
};

/// The intersections between the meshes of a set ("Sets" in doc/definitions.md).
struct SetIntersections {
  /// The pairs of faces, ascending by meshes, then faces: the first ones, at most
  /// MeshRequest::max_list.
  std::vector<SetPair> pairs;
  /// The meshes that are inside others, ascending.
  std::vector<ContainedMesh> contained;
  /// The meshes of which only some components are inside others, ascending.
  std::vector<ContainedMesh> partly_contained;
  /// The numbers of pairs missing from the list, ascending by meshes; empty if the list is
  /// complete.
  std::vector<MeshMeeting> unlisted = {};
  /// Tells whether the search ended at its time limit, so that all numbers are lower bounds.
  bool is_search_stopped = false;

  /// Returns the number of all pairs of faces, listed or not.
  [[nodiscard]] std::size_t n_pairs() const {
    std::size_t n = pairs.size();
    for (const MeshMeeting& meeting : unlisted) n += meeting.pairs.total();
    return n;
  }
};

/// Returns the pairs of meshes that intersect, ascending, with the number of all pairs of their
/// faces, listed or not.
[[nodiscard]] std::vector<MeshMeeting> meetings_of(const SetIntersections& found);

/// Describes the separation distances of vertices.
inline constexpr Quantity kSeparationDistance{
    .info = {.key = "separation_all",
             .label = "separation distance",
             .definition = "from a vertex to the closest point of another mesh; negative where the "
                           "vertex is inside one"},
    .if_none = "no vertex has a closest point"};

/// The statistics of the separation distances of one mesh.
struct MeshSeparation {
  Index mesh = 0;
  Statistics distance;
  /// The number of vertices with no point within the search radius and cone, or without any other
  /// mesh; no statistics include them.
  std::size_t without_closest = 0;
  /// The number of vertices inside another mesh; their distances are negative.
  std::size_t inside = 0;
};

/// The separation distances of a set ("Sets" in doc/definitions.md).
struct SetSeparation {
  SeparationOptions options;
  /// The separation of each mesh, ascending by mesh; meshes without a face are excluded.
  std::vector<MeshSeparation> meshes;
  Statistics all;
  std::size_t without_closest = 0;
  std::size_t inside = 0;
  /// Tells whether distances were measured although a mesh is not good.
  bool is_forced = false;
};

/// The statistics over all vertices, edges and faces of a set.
using SetStatistics = ElementMeasures<Statistics>;

/// A mesh that is not good, and the reasons.
struct UnfitMesh {
  Index mesh = 0;
  std::vector<std::string> reasons;
};

/// The findings about a set of meshes, a plain value that reports render.
struct SetAnalysis {
  /// The names of the meshes by number, unreadable ones included: the names of their files if these
  /// differ, else their paths.
  std::vector<std::string> names;
  /// The number of meshes that were read.
  std::size_t meshes = 0;
  std::size_t unreadable = 0;
  /// The number of meshes that are good: by the thresholds if the request has them, else by the
  /// parts of goodness that need none. It is absent if goodness was not judged.
  std::optional<std::size_t> good;
  /// The meshes that are not good, unreadable files included; ascending.
  std::vector<UnfitMesh> not_good;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t edges = 0;
  std::size_t components = 0;
  std::size_t boundaries = 0;
  /// Tells whether the meshes were measured. With Scope::AttributesOnly they were not, and the next
  /// three members, the volume and the statistics are empty.
  bool is_measured = true;
  std::size_t intersecting_pairs_within = 0;
  /// Tells whether the search within a mesh ended at its time limit, so that the number of pairs is
  /// a lower bound.
  bool is_search_within_stopped = false;
  double area = 0.0;
  /// The total volume of all meshes that have one; the reason names those that have none.
  Measure<double> volume;
  std::optional<SetStatistics> statistics;
  /// The intersections between meshes; present if requested.
  std::optional<SetIntersections> intersections;
  /// The separation distances; present if requested and measured, else `separation_reason` has the
  /// reason.
  std::optional<SetSeparation> separation;
  std::string separation_reason;
};

}  // namespace meshalyzer
