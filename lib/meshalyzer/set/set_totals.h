#pragma once

#include "meshalyzer/base/pooled_values.h"
#include "meshalyzer/base/sum.h"
#include "meshalyzer/set/object_findings.h"
#include "meshalyzer/set/set_analysis.h"
#include "meshalyzer/set/set_options.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// Accumulates the findings about the meshes of a set, one after the other, in memory that does not
/// grow with their faces.
class SetTotals {
 public:
  SetTotals(std::vector<std::string> names, const SetOptions& options);

  /// Adds a mesh; meshes come in ascending order of their numbers. `mesh.values` must be set if
  /// everything is measured.
  void add_mesh(Index number, const Analysis& mesh);
  void add_unreadable(Index number, const std::string& why);
  void add_findings(const ObjectFindings& findings);

  /// Returns the reason why the separation cannot be measured if a mesh is not good; else an empty
  /// text.
  [[nodiscard]] std::string why_no_separation() const;

  /// @return The totals; the object must not be used again.
  /// @complexity O(values), which are read from a temporary file if they are many.
  [[nodiscard]] SetAnalysis finish();

 private:
  void judge(Index number, const Analysis& mesh);
  void begin_separation();
  void add_separation(Index owner, const ObjectSeparation& separation);
  void finish_separation();
  [[nodiscard]] SetStatistics summarize_measures();

  const SetOptions options_;
  SetAnalysis set_;
  CompensatedSum area_;
  CompensatedSum volume_;
  std::size_t without_volume_ = 0;
  ElementMeasures<PooledValues> pooled_;
  PooledValues distance_;
};

}  // namespace meshalyzer
