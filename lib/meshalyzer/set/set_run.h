#pragma once

#include "meshalyzer/set/object_findings.h"
#include "meshalyzer/set/set_analysis.h"
#include "meshalyzer/set/set_options.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// How far a run has come.
struct SetProgress {
  enum class Stage { Files, Between };
  Stage stage = Stage::Files;
  /// Files read, or objects looked at from.
  std::size_t done = 0;
  std::size_t total = 0;
  /// Of those that are done.
  std::size_t faces = 0;
};

/// What a run of a set tells, and asks. The calls come one at a time, in an order that does not
/// depend on the number of threads; known_...() and wants_to_stop() may come at any time, and from
/// several threads at once.
class SetListener {
 public:
  virtual ~SetListener() = default;

  /// What an earlier run has found: then it is not looked for again.
  [[nodiscard]] virtual std::optional<Analysis> known_mesh(Index number);
  /// Why a mesh could not be read.
  [[nodiscard]] virtual std::optional<std::string> known_trouble(Index number);
  [[nodiscard]] virtual std::optional<ObjectFindings> known_findings(Index owner);

  /// Every mesh of this run's shard, in order of the files.
  virtual void on_mesh(Index number, const Analysis& mesh);
  virtual void on_unreadable(Index number, const std::string& why);
  /// Every owner of this run's shard, in the order in space.
  virtual void on_findings(const ObjectFindings& findings);
  virtual void on_progress(const SetProgress& progress);
  /// Asked before each piece of work; once true, it must stay so, and the run ends as soon as it
  /// can.
  [[nodiscard]] virtual bool wants_to_stop();
};

/// Analyses the meshes of a set one by one, and what is between them.
///
/// Files are worked on in parallel, and big ones inside; at most a few at a time, as memory allows.
/// What is told and returned does not depend on the number of threads, nor on the memory limit.
///
/// @param paths     The files; what is read twice must not change meanwhile.
/// @return          Nothing where the listener stopped it, or where the run is but one shard of
///                  several: then what was told is all there is.
/// @throws IoError  where a file cannot be read a second time or has changed; one that cannot be
///                  read the first time is told.
[[nodiscard]] std::optional<SetAnalysis> analyze_set(const std::vector<std::string>& paths,
                                                     const SetOptions& options,
                                                     SetListener& listener);

/// What the meshes of a set are called in its report: the last part of their paths where these
/// differ, else the paths.
[[nodiscard]] std::vector<std::string> set_names(const std::vector<std::string>& paths);

}  // namespace meshalyzer
