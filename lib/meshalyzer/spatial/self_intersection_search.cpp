#include "meshalyzer/spatial/self_intersection_search.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/spatial/contact_in_mesh.h"
#include "meshalyzer/spatial/pair_collector.h"
#include "meshalyzer/spatial/partner_search.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <span>

namespace meshalyzer {
namespace {

/// The number of leaves that one task searches.
constexpr std::size_t kLeavesPerChunk = 64;

/// So few leaves are one task: to start threads would take as long as most searches of them.
constexpr std::size_t kFewLeaves = 320;

/// The numbers of leaves after which a search that may end early tests whether it has found enough:
/// the first, which is then doubled, and the last.
constexpr std::size_t kFewestLeavesPerRound = 2 * kLeavesPerChunk;
constexpr std::size_t kMostLeavesPerRound = 64 * kLeavesPerChunk;

/// The number of pairs that a task keeps before it passes them on.
constexpr std::size_t kPairsInBuffer = 4096;

/// A search by all threads that may end early.
class BoundedSearch {
 public:
  BoundedSearch(const SelfIntersectionScene& scene, const PairLimits& limits,
                PairListener& listener)
      : scene_(scene), limits_(limits), listener_(listener) {}

  /// Runs the search; returns true if all leaves were searched.
  bool run() {
    const std::size_t n_leaves = scene_.tree.n_leaves();
    // The numbers of pairs are compared with the limits between rounds, so that the result does not
    // depend on the threads.
    const bool is_complete = limits_.max_found == kAllPairs && limits_.max_tested == kAllPairs;
    std::size_t per_round = is_complete ? n_leaves : kFewestLeavesPerRound;
    const std::size_t per_chunk =
        is_complete && n_leaves <= kFewLeaves ? kFewLeaves : kLeavesPerChunk;
    if (scene_.groups != nullptr) pair_up_groups();
    std::size_t first = 0;
    while (first < n_leaves && !is_enough(n_found_, n_tested_) && !is_stopped_) {
      const std::size_t end = std::min(first + per_round, n_leaves);
      parallel_chunks(end - first, per_chunk, [&](Chunk chunk) {
        n_found_ += search(first + chunk.begin, first + chunk.end);
      });
      first = end;
      per_round = std::min(2 * per_round, kMostLeavesPerRound);
    }
    return first >= n_leaves && !is_ended_;
  }

 private:
  [[nodiscard]] bool is_enough(std::size_t n_found, std::size_t n_tested) const {
    return n_found >= limits_.max_found || n_tested >= limits_.max_tested;
  }

  /// Searches a chunk of leaves until it has done enough by itself; returns the number of pairs.
  std::size_t search(std::size_t begin, std::size_t end) {
    PairBuffer found(listener_, kPairsInBuffer);
    std::size_t n_tested = 0;
    for (std::size_t leaf = begin; leaf < end; ++leaf) {
      if (is_enough(found.n_pushed(), n_tested) || wants_to_stop()) {
        is_ended_ = true;
        break;
      }
      if (wanted_lanes(scene_, leaf) == 0) continue;
      n_tested += find_partners(scene_, leaf, found);
    }
    n_tested_ += n_tested;
    found.flush();
    return found.n_pushed();
  }

  /// Passes on the pairs within the groups.
  void pair_up_groups() {
    PairBuffer found(listener_, kPairsInBuffer);
    for (std::size_t i = 0; i < scene_.groups->size(); ++i) {
      const auto [a, b] = scene_.groups->two_slots(i);
      const auto kind =
          find_contact_in_mesh(scene_.tree, scene_.tree.triangle(a), scene_.tree.triangle(b));
      const std::span<const Index> faces = scene_.groups->faces(i);
      if (kind) found.push(PairProduct{faces, faces, *kind});
    }
    n_found_ += found.n_pushed();
  }

  bool wants_to_stop() {
    if (!is_stopped_ && limits_.wants_to_stop()) is_stopped_ = true;
    return is_stopped_;
  }

  const SelfIntersectionScene& scene_;
  const PairLimits& limits_;
  PairListener& listener_;
  std::atomic<std::size_t> n_found_ = 0;
  std::atomic<std::size_t> n_tested_ = 0;
  std::atomic<bool> is_stopped_ = false;
  /// Tells whether leaves were left out.
  std::atomic<bool> is_ended_ = false;
};

}  // namespace

bool search_self_intersections(const SelfIntersectionScene& scene, const PairLimits& limits,
                               PairListener& listener) {
  return BoundedSearch(scene, limits, listener).run();
}

}  // namespace meshalyzer
