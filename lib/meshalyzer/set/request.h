#pragma once

#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/set/separation.h"

#include <optional>

namespace meshalyzer {

/// Says what to find out between the meshes of a set.
struct SetQuestions {
  /// Asks which faces of different meshes share a point, and which meshes are inside others.
  bool intersections = false;
  /// Tells how far each vertex is from the closest other mesh.
  std::optional<SeparationOptions> separation = std::nullopt;
  /// The statistics over the faces, edges and vertices of all meshes.
  bool statistics = true;
  /// Measure separation although a mesh is not good.
  bool force = false;

  /// Tells whether any of it is about what lies between the meshes.
  [[nodiscard]] bool is_between() const { return intersections || separation; }

  friend bool operator==(const SetQuestions&, const SetQuestions&) = default;
};

/// Says what a run finds out about meshes and between them: everything that decides what is found,
/// nothing about how it is told. Runs with equal requests find the same in the same files, but for
/// what a time limit leaves out.
struct Request {
  /// What to find out about each mesh.
  MeshRequest mesh;
  /// Keep the offending elements by their ids, not only their numbers.
  bool list_offenders = false;
  /// The meshes are a set, of which there is something to say beside what is said of each.
  bool is_set = false;
  /// Between the meshes of a set.
  SetQuestions between;
  /// Searches for intersecting pairs end so many seconds after the run began, with what they have
  /// found by then.
  std::optional<double> time_limit;

  friend bool operator==(const Request&, const Request&) = default;
};

}  // namespace meshalyzer
