#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/set/object_findings.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace meshalyzer {

/// Tells how far a run has come.
struct RunProgress {
  enum class Stage : std::uint8_t { Files, Between };
  Stage stage = Stage::Files;
  /// Files read, or objects looked at from.
  std::size_t done = 0;
  std::size_t total = 0;
  /// The number of faces in the items that are done.
  std::size_t faces = 0;
};

/// Hears what a run finds. The calls come one at a time, in an order that does not depend on the
/// number of threads; wants_to_stop() may come at any time, and from several threads at once.
class RunListener {
 public:
  virtual ~RunListener() = default;

  /// Every mesh of this run's shard, in order of the files.
  virtual void on_mesh(Index /*number*/, const Analysis& /*mesh*/) {}
  virtual void on_unreadable(Index /*number*/, const std::string& /*why*/) {}
  /// Every owner of this run's shard, in the order in space.
  virtual void on_findings(const ObjectFindings& /*findings*/) {}
  virtual void on_progress(const RunProgress& /*progress*/) {}
  /// Asked before each piece of work; once true, it must stay so, and the run ends as soon as it
  /// can.
  [[nodiscard]] virtual bool wants_to_stop() { return false; }
};

}  // namespace meshalyzer
