#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/base/progress.h"
#include "meshalyzer/spatial/pair_limits.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace meshalyzer {

/// Thresholds of goodness ("Good" in doc/definitions.md).
struct GoodnessThresholds {
  /// The largest aspect ratio must be below this.
  double aspect_ratio = 0.0;
  /// The smallest edge angle must be above this, in degrees.
  double edge_angle_degrees = 0.0;
  /// The shortest edge must be longer than this.
  double edge_length = 0.0;

  friend bool operator==(const GoodnessThresholds&, const GoodnessThresholds&) = default;
};

/// Tells how much of a mesh is looked at.
enum class Scope {
  /// All attributes, counts and measures of doc/definitions.md.
  Everything,
  /// The five attributes, the integrity of the file, and what follows from the topology alone.
  AttributesOnly,
};

/// Says what to find out about a mesh and which elements to name. Nothing else decides what is
/// found.
struct MeshRequest {
  Scope scope = Scope::Everything;
  /// Judge goodness against these.
  std::optional<GoodnessThresholds> goodness;
  /// Name edges shorter / longer than this.
  std::optional<double> shorter_than;
  std::optional<double> longer_than;
  /// Name edges with an angle smaller / larger than this, in degrees.
  std::optional<double> angle_below_degrees;
  std::optional<double> angle_above_degrees;
  /// Name faces with an aspect ratio larger than this.
  std::optional<double> aspect_above;
  /// Counts only vertices at exactly the same place as indistinguishable.
  bool exact_coincidence = false;
  /// Judges Analysis::fitness with Scope::AttributesOnly too, for callers that work on good meshes
  /// only.
  bool judge_fitness = false;
  /// Measure the curvature, spread over this area.
  std::optional<VertexArea> curvature;
  /// Lists of intersecting pairs hold at most so many: those of the lowest faces. 0: all.
  std::size_t max_list = 1'000'000;

  friend bool operator==(const MeshRequest&, const MeshRequest&) = default;
};

/// Says how to analyse a mesh: what to find out, and what else to keep.
struct AnalysisOptions : MeshRequest {
  /// Keep the measured values in the result, for the statistics of a set.
  bool keep_values = false;
  /// Keep the file in the result, for reports that show places.
  bool keep_soup = false;
  /// Keep the file and what was built for it in the result, for finding defects and for pictures.
  bool keep_mesh = false;
  PhaseListener on_phase;
  /// Asked now and then, by any thread: the search for intersecting pairs ends when it returns
  /// true.
  std::function<bool()> wants_to_stop;
};

/// Returns the limits of a search for the pairs that a request asks for.
[[nodiscard]] PairLimits pair_limits(const MeshRequest& request,
                                     std::function<bool()> wants_to_stop);

/// Analyses one mesh.
///
/// The result is the same for any number of threads, and but for numbering for any order of the
/// records.
///
/// @param soup     The file. Taken by value: its arrays are freed as soon as they are no longer
/// needed.
/// @param path     What the report calls it.
/// @complexity     O(n log n) in the number of faces for meshes whose faces meet few others.
[[nodiscard]] Analysis analyze(Soup soup, std::string path, const AnalysisOptions& options = {});

}  // namespace meshalyzer
