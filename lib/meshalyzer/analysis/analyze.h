#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/base/progress.h"
#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/spatial/pair_limits.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace meshalyzer {

/// Thresholds of goodness ("Good" in doc/definitions.md). They may be infinite, but are not NaN.
struct GoodnessThresholds {
  /// The largest aspect ratio must be below this.
  double aspect_ratio = 0.0;
  /// The smallest edge angle must be above this, in degrees.
  double edge_angle_degrees = 0.0;
  /// The shortest edge must be longer than this.
  double edge_length = 0.0;

  friend bool operator==(const GoodnessThresholds&, const GoodnessThresholds&) = default;
};

/// The scope of an analysis.
enum class Scope {
  /// The analysis finds all attributes, counts and measures of doc/definitions.md.
  Everything,
  /// The analysis finds the five attributes, the integrity of the file, and the topological counts.
  AttributesOnly,
};

/// A request: what to find out about a mesh and which elements to name. Nothing else influences the
/// findings. Thresholds may be infinite, but are not NaN.
struct MeshRequest {
  Scope scope = Scope::Everything;
  /// The thresholds against which goodness is judged, if it is.
  std::optional<GoodnessThresholds> goodness;
  /// Edges shorter than this are listed.
  std::optional<double> shorter_than;
  std::optional<double> longer_than;
  /// Edges with an angle below this, in degrees, are listed.
  std::optional<double> angle_below_degrees;
  std::optional<double> angle_above_degrees;
  /// Faces with a larger aspect ratio are listed.
  std::optional<double> aspect_above;
  /// Counts only vertices at exactly the same place as indistinguishable.
  bool exact_coincidence = false;
  /// Judges Analysis::fitness with Scope::AttributesOnly too, for callers that work on good meshes
  /// only.
  bool judge_fitness = false;
  /// The area for the curvature, if that is measured.
  std::optional<VertexArea> curvature;
  /// The largest number of intersecting pairs that are listed: those of the lowest faces; 0 lists
  /// all.
  std::size_t max_list = 1'000'000;

  friend bool operator==(const MeshRequest&, const MeshRequest&) = default;
};

/// What is kept of a prepared mesh when its analysis is done.
enum class MeshKept : std::uint8_t {
  Nothing,
  /// The half-edge mesh, its tree and its components with their boxes, for the work between meshes.
  ForNeighbours,
  /// All of it and the records, for finding defects and for pictures.
  Everything,
};

/// The options of analyze(): what to find out, and what else to keep.
struct AnalysisOptions : MeshRequest {
  /// Keeps the measured values in the result, for the statistics of a set.
  bool keep_values = false;
  /// Keeps the file in the result, for reports that show positions.
  bool keep_soup = false;
  /// What to keep of the prepared mesh in the result.
  MeshKept keep_mesh = MeshKept::Nothing;
  PhaseListener on_phase;
  /// Called now and then, from any thread: the search for intersecting pairs ends when it returns
  /// true.
  StopQuery wants_to_stop;
};

/// Returns the limits of the search for intersecting pairs of a request.
[[nodiscard]] PairLimits pair_limits(const MeshRequest& request, StopQuery wants_to_stop);

/// Analyses one mesh.
///
/// The result is the same for any number of threads and, apart from numbering, for any order of the
/// records.
///
/// @param soup     The file, by value: its arrays are freed as soon as they are no longer needed.
/// @param path     The name of the file in the report.
/// @throws InvalidArgument  as build(); if a position is not finite; and if a threshold is NaN.
/// @complexity     O(n log n) in the number of faces for meshes whose faces meet few others.
[[nodiscard]] Analysis analyze(Soup soup, std::string path, const AnalysisOptions& options = {});

}  // namespace meshalyzer
