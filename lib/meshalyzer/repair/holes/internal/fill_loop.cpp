#include "meshalyzer/repair/holes/internal/fill_loop.h"

#include "meshalyzer/repair/holes/internal/fill_memory.h"
#include "meshalyzer/repair/holes/internal/rim_bend.h"
#include "meshalyzer/repair/holes/internal/smooth_patch.h"
#include "meshalyzer/repair/holes/internal/triangulate_large_loop.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

namespace meshalyzer {
namespace {

/// Loops of up to this number of edges get more rounds of tries, since each takes little time.
constexpr std::size_t kCheapLoop = 64;
constexpr std::size_t kRoundsWhereCheap = 4;
constexpr std::size_t kRounds = 2;
/// Loops of at most this number of edges are filled without new vertices if the shape may be
/// chosen.
constexpr std::size_t kFewEdges = 5;
/// A patch with a smaller mean angle between it and the surface round it, in radians, is smooth.
constexpr double kSmoothBend = std::numbers::pi / 6.0;
/// A smooth patch gets at most about this number of new vertices: fairing takes a second for twice
/// as many.
constexpr std::size_t kMaxNew = 10'000;
/// Where each triangulation intersects something, a smooth patch is tried last. One that needs many
/// new vertices bulges far, and intersects something too: of 747 such patches with more than seven,
/// in 109 meshes, each did.
constexpr std::size_t kMaxNewAtLast = 100;
/// Loops of up to this number of edges are also tried with a fan round one new vertex.
constexpr std::size_t kMaxFan = 64;

class LoopFiller {
 public:
  LoopFiller(const FillTask& task, const JoinedLoop& loop)
      : task_(task),
        loop_(loop.loop),
        polygon_(make_polygon(task.mesh, loop.loop, task.degeneracy)),
        checker_(task.mesh),
        rules_{.existing = &task.existing, .bridges = loop.bridges} {
    for (const Index v : loop_.vertices) region_.extend(task.mesh.soup().positions[v]);
  }

  /// Returns the box of all patches that were tried.
  [[nodiscard]] const Box3& region() const { return region_; }

  [[nodiscard]] std::optional<Patch> triangulated() const {
    auto triangles = triangulate_large_loop(polygon_, rules_, task_.triangulations);
    if (!triangles) return std::nullopt;
    return Patch{.triangles = std::move(*triangles), .added = {}};
  }

  [[nodiscard]] Filling run() {
    std::optional<Patch> patch = try_triangulations();
    if (patch && wants_smooth(*patch)) {
      std::optional<Patch> smooth = try_smooth(*patch, kMaxNew);
      if (smooth && is_smooth_enough(*smooth, *patch)) patch = std::move(smooth);
    }
    if (!patch) patch = try_fan();
    if (!patch && first_) patch = try_smooth(*first_, kMaxNewAtLast);
    filling_.patch = std::move(patch);
    if (!filling_.patch) {
      filling_.reason = has_tried_ ? "every patch tried intersects the mesh"
                                   : "every patch would give an edge a third face";
      filling_.first = std::move(least_bent_);
    }
    return std::move(filling_);
  }

 private:
  [[nodiscard]] std::size_t n_rounds() const {
    // The connection of loops is a guess, and there may be many.
    if (!rules_.bridges.empty()) return 1;
    return polygon_.size() <= kCheapLoop ? kRoundsWhereCheap : kRounds;
  }

  /// Tries triangulations by all weights, again and again without the triangles that intersected
  /// something.
  [[nodiscard]] std::optional<Patch> try_triangulations() {
    constexpr std::array kWeights{LoopWeight::BendThenArea, LoopWeight::Area, LoopWeight::Flat};
    std::vector<Triangle> met;
    for (std::size_t i = 0; i < n_rounds() * kWeights.size(); ++i) {
      if (task_.wants_to_stop()) return std::nullopt;
      rules_.weight = kWeights[i % kWeights.size()];
      if (i % kWeights.size() == 0) rules_.forbid(std::exchange(met, {}));
      std::optional<Patch> patch = triangulated();
      if (i == 0) least_bent_ = patch;
      if (!patch) continue;
      has_tried_ = true;
      const PatchFaults faults = checker_.check(*patch);
      if (faults.empty()) return patch;
      for (const Index t : faults.meeting) met.push_back(patch->triangles[t]);
      if (!first_) first_ = std::move(patch);
    }
    return std::nullopt;
  }

  /// Returns a new vertex in the middle of the loop, with a triangle for each edge.
  [[nodiscard]] std::optional<Patch> try_fan() {
    // The middle of three points lies in their plane, so that a fan is no better than the triangle,
    // and beyond it only by rounding.
    if (polygon_.size() == 3 || polygon_.size() > kMaxFan || !rules_.bridges.empty()) {
      return std::nullopt;
    }
    const Soup& soup = task_.mesh.soup();
    const double share = 1.0 / static_cast<double>(loop_.size());
    Vec3 middle = Vec3::Zero();
    for (const Index v : loop_.vertices) middle += share * soup.positions[v];
    Patch fan{.triangles = {}, .added = {middle}};
    const auto centre = static_cast<Index>(soup.n_vertices());
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      fan.triangles.push_back({loop_.vertices[i], loop_.next(i), centre});
    }
    has_tried_ = true;
    if (!is_sound(task_.mesh, fan)) return std::nullopt;
    return fan;
  }

  [[nodiscard]] bool wants_smooth(const Patch& patch) const {
    if (task_.shape != FillShape::Auto) return task_.shape == FillShape::Smooth;
    return loop_.size() > kFewEdges && bends_into_hole(task_.mesh, loop_, patch);
  }

  /// Tells whether a smooth patch may replace the one that it was made of.
  [[nodiscard]] bool is_smooth_enough(const Patch& smooth, const Patch& patch) const {
    return task_.shape == FillShape::Smooth ||
           mean_rim_bend(task_.mesh, loop_, smooth) <=
               std::max(kSmoothBend, mean_rim_bend(task_.mesh, loop_, patch));
  }

  [[nodiscard]] std::optional<Patch> try_smooth(const Patch& patch, std::size_t max_new) {
    std::optional<Patch> smooth = smooth_patch(task_, loop_, patch, max_new);
    if (!smooth) return std::nullopt;
    for (const Vec3& p : smooth->added) region_.extend(p);
    if (!is_sound(task_.mesh, *smooth)) return std::nullopt;
    return smooth;
  }

  const FillTask& task_;
  const HoleLoop& loop_;
  LoopPolygon polygon_;
  TriangulationChecker checker_;
  LoopRules rules_;
  Box3 region_;
  Filling filling_;
  bool has_tried_ = false;
  /// The triangulation that was tried first, and the first that was possible.
  std::optional<Patch> least_bent_;
  std::optional<Patch> first_;
};

std::optional<Filling> known_failure(const FillTask& task, const JoinedLoop& loop) {
  return task.memory == nullptr ? std::nullopt : task.memory->recall(loop.loop);
}

}  // namespace

std::optional<Patch> first_patch(const FillTask& task, const JoinedLoop& loop) {
  if (std::optional<Filling> known = known_failure(task, loop)) return std::move(known->first);
  return LoopFiller(task, loop).triangulated();
}

Filling fill_loop(const FillTask& task, const JoinedLoop& loop) {
  if (std::optional<Filling> known = known_failure(task, loop)) return std::move(*known);
  LoopFiller filler(task, loop);
  Filling filling = filler.run();
  if (task.memory != nullptr && !filling.patch && !task.wants_to_stop()) {
    task.memory->note(loop.loop, filler.region(), filling);
  }
  return filling;
}

}  // namespace meshalyzer
