#include "meshalyzer/set/set_run.h"

#include "meshalyzer/base/deadline.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/parallel_in_order.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/set/file_run.h"
#include "meshalyzer/set/file_stamp.h"
#include "meshalyzer/set/measure_separation.h"
#include "meshalyzer/set/meetings.h"
#include "meshalyzer/set/object_meeting.h"
#include "meshalyzer/set/require_options.h"
#include "meshalyzer/set/set_files.h"
#include "meshalyzer/set/set_totals.h"
#include "meshalyzer/spatial/box_tree.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

namespace meshalyzer {
namespace {

/// For each thread so many objects may wait until the findings of an earlier one have been used.
/// Findings are small beside objects.
constexpr std::size_t kOwnersPerThread = 8;

struct Numbered {
  Index number;
  const SetObject& object;
};

/// @param meeting  The meeting of `a` and `b`, in this order; a.number < b.number.
SetIntersections intersections_of(const ObjectMeeting& meeting, const Numbered& a,
                                  const Numbered& b) {
  SetIntersections found;
  for (const IntersectingPair& pair : meeting.pairs) {
    found.pairs.push_back({a.number, a.object.face_ids().of(pair.face_a), b.number,
                           b.object.face_ids().of(pair.face_b), pair.kind});
  }
  if (meeting.pairs.size() < meeting.counts.total()) {
    MeshMeeting& unlisted = found.unlisted.emplace_back(MeshMeeting{a.number, b.number, {}});
    ContactCounts listed;
    listed.add(meeting.pairs);
    for (const ContactKind kind : kContactKinds) {
      unlisted.pairs.add(kind, meeting.counts.of(kind) - listed.of(kind));
    }
  }
  found.is_search_stopped = meeting.is_search_stopped;
  const auto add = [&](Inclusion inclusion, ContainedMesh contained) {
    if (inclusion != Inclusion::None) {
      (inclusion == Inclusion::Wholly ? found.contained : found.partly_contained)
          .push_back(contained);
    }
  };
  add(meeting.first_in_second, {a.number, b.number});
  add(meeting.second_in_first, {b.number, a.number});
  return found;
}

class SetRun {
 public:
  SetRun(const std::vector<std::string>& paths, const SetOptions& options, RunListener& listener)
      : paths_(paths),
        options_(options_of_set(options)),
        listener_(listener),
        totals_(set_names(paths), options_),
        boxes_(paths.size()),
        n_faces_(paths.size(), 0) {
    std::transform(paths.begin(), paths.end(), std::back_inserter(stamps_), stamp_of);
  }

  std::optional<SetAnalysis> run() {
    if (options_.request.between.is_between()) {
      objects_.emplace(paths_.size(), memory_for_objects(options_.memory_limit),
                       [this](std::size_t i) { return load(i); });
    }
    FileRun files(paths_, options_, listener_, deadline_);
    is_stopped_ = !files.run([this](Index number, const FileResult& file) { take(number, file); });
    if (!is_stopped_) {
      look_between();
    }
    if (is_stopped_ || options_.shard.count > 1) {
      return std::nullopt;
    }
    return totals_.finish();
  }

 private:
  static SetOptions options_of_set(SetOptions options) {
    options.request.is_set = true;
    return options;
  }

  Next stop() {
    is_stopped_ = true;
    return Next::Stop;
  }

  void take(Index number, const FileResult& file) {
    boxes_[number] = file.box;
    n_faces_[number] = file.n_faces;
    if (file.object) objects_->add(number, file.object);
    if (file.kind == FileResult::Kind::Mesh) {
      totals_.add_mesh(number, file.mesh);
    } else if (file.kind == FileResult::Kind::Unreadable && options_.shard.owns_file(number)) {
      totals_.add_unreadable(number, file.error);
    }
  }

  void look_between() {
    wanted_ = options_.request.between;
    const std::string why_no_separation = totals_.why_no_separation();
    if (wanted_.separation && !why_no_separation.empty()) {
      wanted_.separation.reset();
      listener_.on_no_separation(why_no_separation);
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
    const ShardRange range = range_of(options_.shard, order_, n_faces_);
    progress_ = {.stage = RunProgress::Stage::Between, .total = range.end - range.begin};
    parallel_in_order(
        range.end - range.begin, kOwnersPerThread * max_threads(),
        [&](std::size_t i) { return look_from(order_[range.begin + i]); },
        [&](std::size_t, const ObjectFindings& findings) {
          return listener_.wants_to_stop() ? stop() : notify(findings);
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

  [[nodiscard]] ObjectFindings look_from(Index owner) {
    if (listener_.wants_to_stop()) {
      return {};
    }
    const EarlierFindings* earlier = options_.earlier;
    if (std::optional<ObjectFindings> known = earlier ? earlier->findings(owner) : std::nullopt) {
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
      findings.intersections = intersect_from(owner);
    }
    if (wanted_.separation) {
      findings.separation = measure_separation(
          owner, {.boxes = boxes_, .tree = *box_tree_, .objects = *objects_}, *wanted_.separation);
    }
    return findings;
  }

  [[nodiscard]] SetIntersections intersect_from(Index owner) {
    const std::size_t max_list = options_.request.mesh.max_list;
    const PairLimits limits =
        pair_limits(options_.request.mesh, end_of_search(options_.request, deadline_));
    SetIntersections found;
    for (const Index other : box_tree_->meeting(boxes_[owner])) {
      if (rank_[other] > rank_[owner]) {
        if (limits.wants_to_stop()) {
          found.is_search_stopped = true;
          break;
        }
        const auto [a, b] = std::minmax(owner, other);
        const auto first = objects_->get(a);
        const auto second = objects_->get(b);
        append_intersections(
            intersections_of(find_meeting(*first, *second, limits), {a, *first}, {b, *second}),
            max_list, found);
      }
    }
    return in_order(std::move(found), max_list);
  }

  Next notify(const ObjectFindings& findings) {
    totals_.add_findings(findings);
    listener_.on_findings(findings);
    ++progress_.done;
    progress_.faces += n_faces_[findings.owner];
    listener_.on_progress(progress_);
    return Next::GoOn;
  }

  const std::vector<std::string>& paths_;
  const SetOptions options_;
  RunListener& listener_;
  const Deadline deadline_{options_.request.time_limit};
  SetTotals totals_;
  std::vector<FileStamp> stamps_;
  /// The boxes of the objects; empty for files that cannot be read or have no face.
  std::vector<Box3> boxes_;
  std::vector<std::size_t> n_faces_;
  /// The progress of the work between objects.
  RunProgress progress_;
  bool is_stopped_ = false;
  /// The questions that remain after the analysis of the files.
  SetQuestions wanted_;
  std::vector<Index> order_;
  /// The position of each object in order_.
  std::vector<Index> rank_;
  std::optional<BoxTree> box_tree_;
  /// There if anything between objects is asked for.
  std::optional<ObjectCache> objects_;
};

}  // namespace

std::optional<SetAnalysis> analyze_set(const std::vector<std::string>& paths,
                                       const SetOptions& options, RunListener& listener) {
  require_valid(options);
  return SetRun(paths, options, listener).run();
}

}  // namespace meshalyzer
