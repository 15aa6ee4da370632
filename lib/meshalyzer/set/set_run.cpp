#include "meshalyzer/set/set_run.h"

#include "meshalyzer/analysis/measure_again.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/parallel_in_order.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/set/file_stamp.h"
#include "meshalyzer/set/measure_separation.h"
#include "meshalyzer/set/object_meeting.h"
#include "meshalyzer/set/set_totals.h"
#include "meshalyzer/spatial/box_tree.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <new>
#include <unordered_set>
#include <utility>

namespace meshalyzer {
namespace {

/// About the bytes of memory that the analysis of a file takes for each byte of it.
constexpr std::uint64_t kMemoryPerFileByte = 12;

/// What came of one file.
struct FileResult {
  enum class Kind { Mesh, Unreadable, OfAnotherShard };
  Kind kind = Kind::OfAnotherShard;
  Analysis mesh;
  std::string trouble;
  /// What the work between objects needs to know of it, whichever shard analyses it.
  Box3 box;
  std::size_t n_faces = 0;
};

Box3 box_of(const Soup& soup) {
  Box3 box;
  for (const Triangle& t : soup.triangles) {
    if (is_in_complex(t)) {
      for (const Index v : t) {
        box.extend(soup.positions[v]);
      }
    }
  }
  return box;
}

struct Numbered {
  Index number;
  const SetObject& object;
};

/// @param meeting  Of `a` and `b`, in this order; a.number < b.number.
void add_meeting(const ObjectMeeting& meeting, const Numbered& a, const Numbered& b,
                 SetIntersections& found) {
  for (const IntersectingPair& pair : meeting.pairs) {
    found.pairs.push_back({a.number, a.object.face_ids().of(pair.face_a), b.number,
                           b.object.face_ids().of(pair.face_b), pair.kind});
  }
  const auto add = [&](Inclusion inclusion, ContainedMesh contained) {
    if (inclusion != Inclusion::None) {
      (inclusion == Inclusion::Wholly ? found.contained : found.partly_contained)
          .push_back(contained);
    }
  };
  add(meeting.first_in_second, {a.number, b.number});
  add(meeting.second_in_first, {b.number, a.number});
}

class SetRun {
 public:
  SetRun(const std::vector<std::string>& paths, const SetOptions& options, SetListener& listener)
      : paths_(paths),
        options_(options),
        listener_(listener),
        totals_(set_names(paths), options),
        boxes_(paths.size()),
        n_faces_(paths.size(), 0) {
    std::transform(paths.begin(), paths.end(), std::back_inserter(stamps_), stamp_of);
  }

  std::optional<SetAnalysis> run() {
    look_at_files();
    if (!is_stopped_) {
      look_between();
    }
    if (is_stopped_ || is_shard()) {
      return std::nullopt;
    }
    return totals_.finish();
  }

 private:
  [[nodiscard]] bool is_shard() const { return options_.shard.count > 1; }

  Next stop() {
    is_stopped_ = true;
    return Next::Stop;
  }

  void look_at_files() {
    progress_ = {.stage = SetProgress::Stage::Files, .total = paths_.size()};
    parallel_in_order(
        paths_.size(), n_files_at_once(),
        [&](std::size_t i) { return look_at(static_cast<Index>(i)); },
        [&](std::size_t i, const FileResult& result) {
          return listener_.wants_to_stop() ? stop() : tell(static_cast<Index>(i), result);
        });
  }

  /// As many files as the largest of them leave memory for.
  [[nodiscard]] std::size_t n_files_at_once() const {
    std::vector<std::uint64_t> bytes(stamps_.size());
    std::transform(stamps_.begin(), stamps_.end(), bytes.begin(),
                   [](const FileStamp& stamp) { return stamp.bytes; });
    std::sort(bytes.begin(), bytes.end(), std::greater<>());
    const std::size_t most = std::min(2 * max_threads(), bytes.size());
    std::uint64_t memory = 0;
    std::size_t n = 0;
    while (n < most && (memory += kMemoryPerFileByte * bytes[n]) <= options_.memory_limit) {
      ++n;
    }
    return std::max<std::size_t>(1, n);
  }

  FileResult look_at(Index number) const {
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

  static FileResult unreadable(std::string why) {
    FileResult result;
    result.kind = FileResult::Kind::Unreadable;
    result.trouble = std::move(why);
    return result;
  }

  [[nodiscard]] FileResult look_at_own(Index number) const {
    if (std::optional<std::string> trouble = listener_.known_trouble(number)) {
      return unreadable(std::move(*trouble));
    }
    FileResult result;
    result.kind = FileResult::Kind::Mesh;
    if (std::optional<Analysis> known = listener_.known_mesh(number)) {
      result.mesh = std::move(*known);
      if (wants_values()) {
        result.mesh.values = measure_again(read_mesh(paths_[number]));
      }
    } else {
      AnalysisOptions options = options_.analysis;
      options.judge_fitness = options.judge_fitness || options_.questions.separation;
      options.keep_values = wants_values();
      result.mesh = analyze(read_mesh(paths_[number]), paths_[number], options);
    }
    result.box = result.mesh.characteristics.bounding_box;
    result.n_faces = result.mesh.characteristics.faces;
    return result;
  }

  /// The statistics of the set are of no use to a shard, nor where only attributes are asked for.
  [[nodiscard]] bool wants_values() const {
    return !is_shard() && options_.questions.statistics &&
           options_.analysis.scope == Scope::Everything;
  }

  /// Of a file that another shard analyses only its place is needed.
  [[nodiscard]] FileResult glance_at(Index number) const {
    FileResult result;
    if (options_.questions.is_between()) {
      const Soup soup = read_mesh(paths_[number]);
      result.box = box_of(soup);
      result.n_faces = soup.n_faces();
    }
    return result;
  }

  Next tell(Index number, const FileResult& result) {
    boxes_[number] = result.box;
    n_faces_[number] = result.n_faces;
    if (result.kind == FileResult::Kind::Mesh) {
      totals_.add_mesh(number, result.mesh);
      listener_.on_mesh(number, result.mesh);
    } else if (result.kind == FileResult::Kind::Unreadable && options_.shard.owns_file(number)) {
      totals_.add_unreadable(number, result.trouble);
      listener_.on_unreadable(number, result.trouble);
    }
    return advance(result.n_faces);
  }

  Next advance(std::size_t n_faces) {
    ++progress_.done;
    progress_.faces += n_faces;
    listener_.on_progress(progress_);
    return Next::GoOn;
  }

  void look_between() {
    wanted_ = options_.questions;
    if (!totals_.why_no_separation().empty()) {
      wanted_.separation.reset();
    }
    if (!wanted_.is_between()) {
      return;
    }
    box_tree_.emplace(boxes_);
    order_ = box_tree_->order();
    rank_.resize(paths_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) {
      rank_[order_[i]] = static_cast<Index>(i);
    }
    // The rest is for what is being read and built.
    ObjectCache objects(paths_.size(), options_.memory_limit / 8 * 5,
                        [&](std::size_t i) { return load(i); });
    const ShardRange range = range_of(options_.shard, order_, n_faces_);
    progress_ = {.stage = SetProgress::Stage::Between, .total = range.end - range.begin};
    parallel_in_order(
        range.end - range.begin, max_threads(),
        [&](std::size_t i) { return look_from(order_[range.begin + i], objects); },
        [&](std::size_t, const ObjectFindings& findings) {
          return listener_.wants_to_stop() ? stop() : tell(findings);
        });
  }

  [[nodiscard]] std::unique_ptr<const SetObject> load(std::size_t number) const {
    const ClosestUse use = wanted_.separation ? ClosestUse::Prepared : ClosestUse::Never;
    auto object = std::make_unique<const SetObject>(read_mesh(paths_[number]), use);
    if (stamp_of(paths_[number]) != stamps_[number]) {
      throw IoError(paths_[number], {}, "has changed while the set was being analysed");
    }
    return object;
  }

  [[nodiscard]] ObjectFindings look_from(Index owner, ObjectCache& objects) const {
    if (listener_.wants_to_stop()) {
      return {};
    }
    if (std::optional<ObjectFindings> known = listener_.known_findings(owner)) {
      if (!wanted_.intersections) {
        known->intersections.reset();
      }
      if (!wanted_.separation) {
        known->separation.reset();  // another shard could not know that a mesh is not good
      }
      return std::move(*known);
    }
    ObjectFindings findings;
    findings.owner = owner;
    if (wanted_.intersections) {
      findings.intersections = intersect_from(owner, objects);
    }
    if (wanted_.separation) {
      findings.separation = measure_separation(
          owner, {.boxes = boxes_, .tree = *box_tree_, .objects = objects}, *wanted_.separation);
    }
    return findings;
  }

  [[nodiscard]] SetIntersections intersect_from(Index owner, ObjectCache& objects) const {
    SetIntersections found;
    for (const Index other : box_tree_->meeting(boxes_[owner])) {
      if (rank_[other] > rank_[owner]) {
        const auto [a, b] = std::minmax(owner, other);
        const auto first = objects.get(a);
        const auto second = objects.get(b);
        add_meeting(find_meeting(*first, *second), {a, *first}, {b, *second}, found);
      }
    }
    return in_order(std::move(found));
  }

  Next tell(const ObjectFindings& findings) {
    totals_.add_findings(findings);
    listener_.on_findings(findings);
    return advance(n_faces_[findings.owner]);
  }

  const std::vector<std::string>& paths_;
  const SetOptions& options_;
  SetListener& listener_;
  SetTotals totals_;
  std::vector<FileStamp> stamps_;
  /// By number; boxes are empty for what cannot be read or has no face.
  std::vector<Box3> boxes_;
  std::vector<std::size_t> n_faces_;
  SetProgress progress_;
  bool is_stopped_ = false;
  /// What is left to be found out when the files are known.
  SetQuestions wanted_;
  std::vector<Index> order_;
  /// By number: the place in order_.
  std::vector<Index> rank_;
  std::optional<BoxTree> box_tree_;
};

}  // namespace

std::optional<Analysis> SetListener::known_mesh(Index) {
  return std::nullopt;
}
std::optional<std::string> SetListener::known_trouble(Index) {
  return std::nullopt;
}
std::optional<ObjectFindings> SetListener::known_findings(Index) {
  return std::nullopt;
}
void SetListener::on_mesh(Index, const Analysis&) {}
void SetListener::on_unreadable(Index, const std::string&) {}
void SetListener::on_findings(const ObjectFindings&) {}
void SetListener::on_progress(const SetProgress&) {}
bool SetListener::wants_to_stop() {
  return false;
}

std::optional<SetAnalysis> analyze_set(const std::vector<std::string>& paths,
                                       const SetOptions& options, SetListener& listener) {
  return SetRun(paths, options, listener).run();
}

std::vector<std::string> set_names(const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  std::unordered_set<std::string> distinct;
  for (const std::string& path : paths) {
    names.push_back(path.substr(path.find_last_of('/') + 1));
    distinct.insert(names.back());
  }
  return distinct.size() == paths.size() ? names : paths;
}

}  // namespace meshalyzer
