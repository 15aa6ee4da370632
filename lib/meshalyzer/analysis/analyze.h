#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/base/progress.h"

#include <optional>
#include <string>

namespace meshalyzer {

/// The thresholds of -g (contract 3).
struct GoodnessThresholds {
  /// The largest aspect ratio must be below this.
  double aspect_ratio = 0.0;
  /// The smallest edge angle must be above this, in degrees.
  double edge_angle_degrees = 0.0;
  /// The shortest edge must be longer than this.
  double edge_length = 0.0;
};

/// How much of a mesh to look at.
enum class Scope {
  /// Everything of contract 1 and 2.
  Everything,
  /// The five attributes, the integrity of the file, and what follows from the topology alone (-a).
  AttributesOnly,
};

/// What to analyse, and which elements to name.
struct AnalysisOptions {
  Scope scope = Scope::Everything;
  /// Judge goodness against these (-g).
  std::optional<GoodnessThresholds> goodness;
  /// Name edges shorter / longer than this (-b, -c).
  std::optional<double> shorter_than;
  std::optional<double> longer_than;
  /// Name edges with an angle smaller / larger than this, in degrees (-d, -e).
  std::optional<double> angle_below_degrees;
  std::optional<double> angle_above_degrees;
  /// Name faces with an aspect ratio larger than this (-f).
  std::optional<double> aspect_above;
  /// Indistinguishable vertices: only those at exactly the same place (--exact-coincidence).
  bool exact_coincidence = false;
  /// Judge fitness also where only the attributes are asked for: what needs a good mesh asks for
  /// it.
  bool judge_fitness = false;
  /// Keep the measured values in the result, for the statistics of a set.
  bool keep_values = false;
  /// Measure the curvature, spread over this area (--curvature).
  std::optional<VertexArea> curvature;
  /// Keep the file in the result, for reports that show places (-q, --html, --export).
  bool keep_soup = false;
  PhaseListener on_phase;
};

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
