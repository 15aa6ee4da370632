#pragma once

#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/set/separation.h"

#include <optional>

namespace meshalyzer {

/// The questions about the meshes of a set together.
struct SetQuestions {
  /// Requests the intersections: faces of different meshes that share a point, and meshes inside
  /// others.
  bool intersections = false;
  /// Requests the distance of each vertex from the closest other mesh.
  std::optional<SeparationOptions> separation = std::nullopt;
  /// Requests the statistics over the faces, edges and vertices of all meshes.
  bool statistics = true;
  /// Measures the separation even if a mesh is not good.
  bool force = false;

  /// Tells whether any question concerns the relation between meshes.
  [[nodiscard]] bool is_between() const { return intersections || separation; }

  friend bool operator==(const SetQuestions&, const SetQuestions&) = default;
};

/// Everything that determines the findings of a run, and nothing about their presentation. Runs
/// with equal requests find the same in the same files, unless a time limit ends a search.
struct Request {
  /// The questions about each mesh.
  MeshRequest mesh;
  /// Keeps the ids of offending elements, not only their number.
  bool list_offenders = false;
  /// Tells whether the meshes are a set, which is reported as a whole too.
  bool is_set = false;
  /// The questions about the set.
  SetQuestions between;
  /// The time in seconds after the start of the run at which searches for intersecting pairs end,
  /// with what they have found by then. It is not negative.
  std::optional<double> time_limit;

  friend bool operator==(const Request&, const Request&) = default;
};

}  // namespace meshalyzer
