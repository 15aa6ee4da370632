#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/set/object_findings.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace meshalyzer {

/// The progress of a run.
struct RunProgress {
  enum class Stage : std::uint8_t { Files, Between };
  Stage stage = Stage::Files;
  /// The number of files analysed, or of objects compared with the others.
  std::size_t done = 0;
  std::size_t total = 0;
  /// The number of faces in the items that are done.
  std::size_t faces = 0;
};

/// Receives the findings of a run. The calls come one at a time, in an order that does not depend
/// on the number of threads; only wants_to_stop() may be called at any time, and by several threads
/// at once.
class RunListener {
 public:
  virtual ~RunListener() = default;

  /// Receives every mesh of this run's shard, in order of the files.
  virtual void on_mesh(Index /*number*/, const Analysis& /*mesh*/) {}
  virtual void on_unreadable(Index /*number*/, const std::string& /*why*/) {}
  /// Receives the findings of every owner of this run's shard, in the spatial order.
  virtual void on_findings(const ObjectFindings& /*findings*/) {}
  /// Receives the reason why the distances between the meshes are not measured although they were
  /// asked for, before any findings. A shard knows only what is wrong with its own meshes.
  virtual void on_no_separation(const std::string& /*why*/) {}
  virtual void on_progress(const RunProgress& /*progress*/) {}
  /// Called before each piece of work. Once it returns true it must continue to do so, and the run
  /// ends as soon as possible.
  [[nodiscard]] virtual bool wants_to_stop() { return false; }
};

}  // namespace meshalyzer
