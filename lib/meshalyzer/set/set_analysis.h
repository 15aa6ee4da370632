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

/// Two faces of different meshes that share a point; mesh_a < mesh_b. Meshes by their number in the
/// set, faces by id.
struct SetPair {
  Index mesh_a = 0;
  std::int64_t face_a = 0;
  Index mesh_b = 0;
  std::int64_t face_b = 0;
  ContactKind kind = ContactKind::Touching;

  friend bool operator==(const SetPair&, const SetPair&) = default;
};

/// A mesh inside another one, where no faces of theirs cross.
struct ContainedMesh {
  Index inner = 0;
  Index outer = 0;

  friend auto operator<=>(const ContainedMesh&, const ContainedMesh&) = default;
};

/// How the meshes of a set intersect (M 13).
struct SetIntersections {
  /// Ascending by meshes, then faces.
  std::vector<SetPair> pairs;
  /// Ascending.
  std::vector<ContainedMesh> contained;
  /// Where only some components of the inner mesh are inside.
  std::vector<ContainedMesh> partly_contained;
};

/// What is said of the separation distances of vertices.
inline constexpr Quantity kSeparationDistance{
    .info = {.key = "separation_all",
             .label = "separation distance",
             .definition = "from a vertex to the closest point of another mesh; negative where the "
                           "vertex is inside one"},
    .if_none = "no vertex has a closest point"};

/// The separation distances of one mesh, in figures.
struct MeshSeparation {
  Index mesh = 0;
  Statistics distance;
  /// Vertices with nothing within the search radius and cone, or no other mesh at all: they are in
  /// none of the figures.
  std::size_t without_closest = 0;
  /// Vertices that lie inside another mesh; their distances are negative.
  std::size_t inside = 0;
};

/// The separation distances of a set (M 14).
struct SetSeparation {
  SeparationOptions options;
  /// Ascending by mesh; meshes without a face are left out.
  std::vector<MeshSeparation> meshes;
  Statistics all;
  std::size_t without_closest = 0;
  std::size_t inside = 0;
  /// Measured although a mesh is not good (--force).
  bool is_forced = false;
};

/// The statistics over all vertices, edges and faces of a set.
using SetStatistics = ElementMeasures<Statistics>;

/// A mesh that is not good, and why.
struct UnfitMesh {
  Index mesh = 0;
  std::vector<std::string> reasons;
};

/// All that is known of a set of meshes. A plain value: reports render it.
struct SetAnalysis {
  /// What the meshes are called: the names of their files where these differ, else their paths. By
  /// number, unreadable ones included.
  std::vector<std::string> names;
  /// Those that were read.
  std::size_t meshes = 0;
  std::size_t unreadable = 0;
  /// Meshes that are good: with -g by its thresholds, else by the parts of goodness that need none.
  /// Nothing where goodness was not judged (-a).
  std::optional<std::size_t> good;
  /// Those that are not, unreadable files included; ascending.
  std::vector<UnfitMesh> not_good;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t edges = 0;
  std::size_t components = 0;
  std::size_t boundaries = 0;
  /// False where only the attributes were asked for (-a): then the next two, the volume and the
  /// statistics are nothing.
  bool is_measured = true;
  std::size_t intersecting_pairs_within = 0;
  double area = 0.0;
  /// Of all meshes that have one; the reason tells which have none.
  Measure<double> volume;
  std::optional<SetStatistics> statistics;
  /// Where asked for (-i).
  std::optional<SetIntersections> intersections;
  /// Where asked for (-s) and possible; else `separation_reason` tells why not.
  std::optional<SetSeparation> separation;
  std::string separation_reason;
};

}  // namespace meshalyzer
