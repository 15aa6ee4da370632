#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/set/object_findings.h"

#include <optional>
#include <string>

namespace meshalyzer {

/// The findings of earlier runs about the same files with an equal request: they are not looked for
/// again. Any number of threads may ask.
class EarlierFindings {
 public:
  virtual ~EarlierFindings() = default;

  [[nodiscard]] virtual std::optional<Analysis> mesh(Index number) const = 0;
  /// Why a mesh could not be read.
  [[nodiscard]] virtual std::optional<std::string> trouble(Index number) const = 0;
  [[nodiscard]] virtual std::optional<ObjectFindings> findings(Index owner) const = 0;
};

}  // namespace meshalyzer
