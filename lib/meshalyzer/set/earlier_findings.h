#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/set/object_findings.h"

#include <optional>
#include <string>

namespace meshalyzer {

/// The findings of earlier runs on the same files with an equal request, which need not be computed
/// again. Several threads may call at a time.
class EarlierFindings {
 public:
  virtual ~EarlierFindings() = default;

  [[nodiscard]] virtual std::optional<Analysis> mesh(Index number) const = 0;
  /// Returns the reason why a mesh could not be read.
  [[nodiscard]] virtual std::optional<std::string> error(Index number) const = 0;
  [[nodiscard]] virtual std::optional<ObjectFindings> findings(Index owner) const = 0;
};

}  // namespace meshalyzer
