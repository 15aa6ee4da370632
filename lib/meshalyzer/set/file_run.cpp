#include "meshalyzer/set/file_run.h"

#include "meshalyzer/analysis/measure_again.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel_in_order.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/mesh/used_box.h"
#include "meshalyzer/set/files_at_once.h"
#include "meshalyzer/set/object_cache.h"

#include <new>
#include <optional>
#include <utility>

namespace meshalyzer {
namespace {

FileResult unreadable(std::string why) {
  FileResult result;
  result.kind = FileResult::Kind::Unreadable;
  result.error = std::move(why);
  return result;
}

}  // namespace

StopQuery end_of_search(const Request& request, const Deadline& deadline) {
  if (!request.time_limit) return {};
  return [&deadline] { return deadline.is_over(); };
}

FileRun::FileRun(const std::vector<std::string>& paths, const SetOptions& options,
                 RunListener& listener, const Deadline& deadline)
    : paths_(paths),
      options_(options),
      listener_(listener),
      deadline_(deadline),
      progress_{.stage = RunProgress::Stage::Files, .total = paths.size()} {}

bool FileRun::run(const std::function<void(Index, const FileResult&)>& take) {
  bool is_stopped = false;
  parallel_in_order(
      paths_.size(), n_files_at_once(paths_, memory_for_files()),
      [this](std::size_t i) { return look_at(static_cast<Index>(i)); },
      [&](std::size_t i, const FileResult& result) {
        is_stopped = listener_.wants_to_stop();
        if (is_stopped) {
          return Next::Stop;
        }
        take(static_cast<Index>(i), result);
        notify(static_cast<Index>(i), result);
        return Next::GoOn;
      });
  return !is_stopped;
}

FileResult FileRun::look_at(Index number) const {
  if (listener_.wants_to_stop()) {
    return {};
  }
  try {
    return options_.shard.owns_file(number) ? look_at_own(number) : glance_at(number);
  } catch (const IoError& error) {
    return unreadable(error.what());
  } catch (const std::bad_alloc&) {
    return unreadable(paths_[number] + ": not enough memory");
  }
}

FileResult FileRun::look_at_own(Index number) const {
  const EarlierFindings* earlier = options_.earlier;
  if (std::optional<std::string> error = earlier ? earlier->error(number) : std::nullopt) {
    return unreadable(std::move(*error));
  }
  FileResult result;
  result.kind = FileResult::Kind::Mesh;
  if (std::optional<Analysis> known = earlier ? earlier->mesh(number) : std::nullopt) {
    result.mesh = std::move(*known);
    if (wants_values()) {
      result.mesh.values = measure_again(read_mesh(paths_[number]));
    }
  } else {
    result.mesh = analysis_of(number);
    if (keeps_objects() && result.mesh.mesh) result.object = object_of(result.mesh);
  }
  result.box = result.mesh.characteristics.bounding_box;
  result.n_faces = result.mesh.characteristics.faces;
  return result;
}

Analysis FileRun::analysis_of(Index number) const {
  AnalysisOptions options{options_.request.mesh,
                          wants_values(),
                          options_.keep_soup,
                          mesh_kept(),
                          {},
                          end_of_search(options_.request, deadline_)};
  options.judge_fitness =
      options.judge_fitness || (looks_between() && options_.request.between.separation);
  return analyze(read_mesh(paths_[number]), paths_[number], options);
}

std::uint64_t FileRun::memory_for_files() const {
  const std::uint64_t limit = options_.memory_limit;
  return keeps_objects() ? limit - memory_for_objects(limit) : limit;
}

MeshKept FileRun::mesh_kept() const {
  if (options_.keep_mesh) return MeshKept::Everything;
  const bool has_room = object_bytes_ < memory_for_objects(options_.memory_limit);
  return keeps_objects() && has_room ? MeshKept::ForNeighbours : MeshKept::Nothing;
}

/// Tells whether meshes become objects of the set at once: not for pictures, which take memory for
/// the records too, nor in a shard, which needs few of the objects.
bool FileRun::keeps_objects() const {
  return looks_between() && options_.shard.count == 1 && !options_.keep_mesh;
}

std::shared_ptr<const SetObject> FileRun::object_of(Analysis& analysis) const {
  const ClosestUse use =
      options_.request.between.separation ? ClosestUse::Prepared : ClosestUse::Never;
  auto object = std::make_shared<const SetObject>(std::exchange(analysis.mesh, nullptr),
                                                  analysis.vertex_ids, analysis.face_ids, use);
  object_bytes_ += object->bytes();
  return object;
}

/// Tells whether the values for the statistics of the set are needed: not by a shard, nor if only
/// attributes are requested.
bool FileRun::wants_values() const {
  return options_.request.is_set && options_.request.between.statistics &&
         options_.shard.count == 1 && options_.request.mesh.scope == Scope::Everything;
}

bool FileRun::looks_between() const {
  return options_.request.is_set && options_.request.between.is_between();
}

/// Finds the box of a file that another shard analyses, of which nothing else is needed.
FileResult FileRun::glance_at(Index number) const {
  FileResult result;
  if (looks_between()) {
    const Soup soup = read_mesh(paths_[number]);
    result.box = used_box(soup);
    result.n_faces = soup.n_faces();
  }
  return result;
}

void FileRun::notify(Index number, const FileResult& result) {
  if (result.kind == FileResult::Kind::Mesh) {
    listener_.on_mesh(number, result.mesh);
  } else if (result.kind == FileResult::Kind::Unreadable && options_.shard.owns_file(number)) {
    listener_.on_unreadable(number, result.error);
  }
  ++progress_.done;
  progress_.faces += result.n_faces;
  listener_.on_progress(progress_);
}

}  // namespace meshalyzer
