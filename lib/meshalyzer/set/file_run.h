#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/base/deadline.h"
#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/base/types.h"
#include "meshalyzer/set/run_listener.h"
#include "meshalyzer/set/set_object.h"
#include "meshalyzer/set/set_options.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace meshalyzer {

/// The result of one file.
struct FileResult {
  enum class Kind : std::uint8_t { Mesh, Unreadable, OfAnotherShard };
  Kind kind = Kind::OfAnotherShard;
  Analysis mesh;
  std::string error;
  /// The box of the vertices that faces use, which every shard needs for the work between objects;
  /// empty for a file that cannot be read or has no face.
  Box3 box;
  std::size_t n_faces = 0;
  /// The mesh as an object of the set, if it was kept for the work between objects; else null.
  std::shared_ptr<const SetObject> object;
};

/// Returns what ends searches for intersecting pairs: the deadline, if the request has a time
/// limit.
///
/// @param deadline  The deadline, which must outlive the returned query.
[[nodiscard]] StopQuery end_of_search(const Request& request, const Deadline& deadline);

/// Analyses files one by one: a few at a time, as memory allows, and large ones with several
/// threads each. If something between the meshes is asked for, each becomes an object of the set as
/// long as there is memory for them, so that it is read and built once.
class FileRun {
 public:
  /// All arguments must outlive this object.
  ///
  /// @param deadline  The end of searches for intersecting pairs.
  FileRun(const std::vector<std::string>& paths, const SetOptions& options, RunListener& listener,
          const Deadline& deadline);

  /// Reports each file to the listener, in order.
  ///
  /// @param take  Receives each result before the listener does.
  /// @return      True unless the listener stopped the run.
  [[nodiscard]] bool run(const std::function<void(Index, const FileResult&)>& take);

 private:
  [[nodiscard]] FileResult look_at(Index number) const;
  [[nodiscard]] FileResult look_at_own(Index number) const;
  [[nodiscard]] FileResult glance_at(Index number) const;
  [[nodiscard]] Analysis analysis_of(Index number) const;
  [[nodiscard]] bool keeps_objects() const;
  [[nodiscard]] MeshKept mesh_kept() const;
  [[nodiscard]] std::uint64_t memory_for_files() const;
  [[nodiscard]] std::shared_ptr<const SetObject> object_of(Analysis& analysis) const;
  [[nodiscard]] bool wants_values() const;
  [[nodiscard]] bool looks_between() const;
  void notify(Index number, const FileResult& result);

  const std::vector<std::string>& paths_;
  const SetOptions& options_;
  RunListener& listener_;
  const Deadline& deadline_;
  RunProgress progress_;
  /// The memory of the objects that were made for the work between objects.
  mutable std::atomic<std::uint64_t> object_bytes_ = 0;
};

}  // namespace meshalyzer
