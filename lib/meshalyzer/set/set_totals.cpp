#include "meshalyzer/set/set_totals.h"

#include "meshalyzer/analysis/goodness.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/set/meetings.h"
#include "meshalyzer/set/set_counts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace meshalyzer {
namespace {

std::string and_more(std::size_t n) {
  if (n == 0) {
    return "";
  }
  return " and " + std::to_string(n) + (n == 1 ? " more mesh is not" : " more meshes are not");
}

}  // namespace

SetTotals::SetTotals(std::vector<std::string> names, const SetOptions& options)
    : options_(options) {
  set_.names = std::move(names);
  set_.is_measured = options.request.mesh.scope == Scope::Everything;
  if (options.request.between.intersections) {
    set_.intersections.emplace();
  }
}

void SetTotals::add_mesh(Index number, const Analysis& mesh) {
  const Characteristics& c = mesh.characteristics;
  ++set_.meshes;
  for (const SetCount& count : kSetCounts) {
    set_.*count.total += c.*count.of_mesh;
  }
  set_.is_search_within_stopped = set_.is_search_within_stopped || c.is_search_stopped;
  area_.add(c.area);
  volume_.add(c.volume.value.value_or(0.0));
  without_volume_ += c.volume.value ? 0 : 1;
  judge(number, mesh);
  for (std::size_t i = 0; i < kElementMeasures<PooledValues>.size(); ++i) {
    pooled_[i].append(mesh.values[i]);
  }
}

void SetTotals::judge(Index number, const Analysis& mesh) {
  const std::optional<Goodness>& verdict = verdict_of(mesh);
  if (!verdict) {
    return;
  }
  set_.good = set_.good.value_or(0) + (verdict->good ? 1 : 0);
  if (!verdict->good) {
    set_.not_good.push_back({number, verdict->reasons});
  }
}

void SetTotals::add_unreadable(Index number, const std::string& why) {
  ++set_.unreadable;
  set_.not_good.push_back({number, {"cannot be read: " + why}});
}

std::string SetTotals::why_no_separation() const {
  if (set_.not_good.empty() || options_.request.between.force) {
    return "";
  }
  const UnfitMesh& first = set_.not_good.front();
  return "every mesh must be good, and " + set_.names[first.mesh] + " is not (" +
         first.reasons.front() + ")" + and_more(set_.not_good.size() - 1) +
         "; the measurement can be forced";
}

void SetTotals::add_findings(const ObjectFindings& findings) {
  if (findings.intersections) {
    append_intersections(*findings.intersections, options_.request.mesh.max_list,
                         *set_.intersections);
  }
  if (findings.separation) {
    add_separation(findings.owner, *findings.separation);
  }
}

void SetTotals::begin_separation() {
  if (!set_.separation) {
    set_.separation.emplace();
    set_.separation->options = *options_.request.between.separation;
    set_.separation->is_forced = !set_.not_good.empty();
  }
}

void SetTotals::add_separation(Index owner, const ObjectSeparation& separation) {
  begin_separation();
  std::vector<double> found;
  std::copy_if(separation.distances.begin(), separation.distances.end(), std::back_inserter(found),
               [](double distance) { return !std::isnan(distance); });
  MeshSeparation mesh;
  mesh.mesh = owner;
  mesh.without_closest = separation.distances.size() - found.size();
  mesh.inside = static_cast<std::size_t>(std::count_if(
      found.begin(), found.end(), [](double distance) { return std::signbit(distance); }));
  distance_.append(found);
  mesh.distance = summarize(found);
  set_.separation->without_closest += mesh.without_closest;
  set_.separation->inside += mesh.inside;
  set_.separation->meshes.push_back(std::move(mesh));
}

SetStatistics SetTotals::summarize_measures() {
  SetStatistics statistics;
  // To read the values again and select among them is one task for each quantity.
  parallel_chunks(kElementMeasures<PooledValues>.size(), 1,
                  [&](Chunk chunk) { statistics[chunk.begin] = pooled_[chunk.begin].summarize(); });
  return statistics;
}

SetAnalysis SetTotals::finish() {
  set_.area = area_.value();
  if (without_volume_ < set_.meshes) {
    set_.volume.value = volume_.value();
  }
  if (without_volume_ != 0) {
    set_.volume.reason = "meshes without a volume: " + std::to_string(without_volume_);
  }
  if (set_.is_measured && options_.request.between.statistics) {
    set_.statistics = summarize_measures();
  }
  if (set_.intersections) {
    set_.intersections = in_order(std::move(*set_.intersections), options_.request.mesh.max_list);
  }
  if (options_.request.between.separation) {
    finish_separation();
  }
  return std::move(set_);
}

void SetTotals::finish_separation() {
  set_.separation_reason = why_no_separation();
  if (set_.separation_reason.empty()) {
    begin_separation();
    std::sort(set_.separation->meshes.begin(), set_.separation->meshes.end(),
              [](const MeshSeparation& a, const MeshSeparation& b) { return a.mesh < b.mesh; });
    set_.separation->all = distance_.summarize();
  }
}

}  // namespace meshalyzer
