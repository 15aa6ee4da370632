#include "meshalyzer/repair/replace/internal/unite_from_input.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/contour/boundary_samples.h"
#include "meshalyzer/contour/mesh_region.h"
#include "meshalyzer/repair/holes/internal/crossing_patches.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/replace/internal/broken_solids.h"
#include "meshalyzer/repair/replace/internal/join_points.h"
#include "meshalyzer/spatial/closest_point.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The sides of a dropped piece are examined at this distance, as a share of the maximum deviation.
constexpr double kSideReach = 1.0 / 16.0;
/// A union that still touches at no more points is made again with small solids round these, so
/// many times at most.
constexpr std::size_t kMostPointsJoined = 64;
constexpr int kMostTimesJoined = 3;

/// Returns samples of those pieces of faces of a mesh that bound its solid.
std::vector<BoundarySample> boundary_samples(const PassInput& input,
                                             std::span<const Corners> pieces) {
  const ClosestPoints closest(input.mesh.tree());
  std::vector<BoundarySample> samples;
  Index hint = kNoIndex;
  for (const Vec3& point :
       sample_boundary(input.tracked.soup, pieces, kSideReach * input.limits.max_deviation)) {
    const auto found = closest.find({.point = point, .hint = hint});
    hint = found->slot;
    const Index face = input.mesh.cut().side.faces[found->mesh_face];
    samples.push_back({point, input.tracked.face_keys[face]});
  }
  return samples;
}

/// Returns samples of those removed parts of the mesh that bound its solid.
std::vector<BoundarySample> lost_boundary(const PassInput& input, const Edits& edits) {
  std::vector<Corners> pieces;
  pieces.reserve(edits.interior_walls.size());
  for (const auto& removed : edits.interior_walls) pieces.push_back(removed.wall.corners);
  return boundary_samples(input, pieces);
}

/// Finds the samples of all of the mesh that bounds its solid, unless they are known.
void sample_whole(const PassInput& input, SampledBoundary& boundary) {
  const Soup& soup = input.tracked.soup;
  const std::vector<Index>& face_keys = input.tracked.face_keys;
  if (boundary.positions == soup.positions && boundary.triangles == soup.triangles &&
      boundary.face_keys == face_keys) {
    return;
  }
  std::vector<Corners> faces;
  for (const Index face : input.mesh.cut().side.faces) faces.push_back(corners_of(soup, face));
  boundary = {soup.positions, soup.triangles, face_keys, boundary_samples(input, faces)};
}

/// Tells whether more holes are filled if those of sheets are.
bool fills_more_with_sheets(const PassInput& input, FillOptions fill) {
  fill.sheets = FillSheets::No;
  const std::size_t n_without = crossing_patches(input, fill).size();
  fill.sheets = FillSheets::Yes;
  return crossing_patches(input, fill).size() != n_without;
}

class UnionFromInput {
 public:
  UnionFromInput(RepairDriver& driver, const RepairOptions& options, const Tolerances& tolerances,
                 const UnionChoice& choice, UnionMemory& memory)
      : driver_(driver),
        options_(options),
        tolerances_(tolerances),
        choice_(choice),
        memory_(memory),
        check_(final_check_for(options, driver.mesh().input().format)) {}

  bool run() {
    if (!may_fix() || driver_.is_stopped() || !(driver_.mesh().max_deviation() > 0.0)) return false;
    if (is_good_in_file(driver_.mesh().state(), tolerances_, check_)) return false;
    const BrokenSolid whole = whole_mesh_as_solid(driver_.mesh().prepared());
    if (options_.solid ? !whole.any_bounds_solid : !whole.all_bound_solid) return false;
    // A patch over a sheet encloses a region that the sheet does not mean as a solid, so that is
    // tried last.
    return unite(FillSheets::No) || (options_.solid && !is_too_far_ && unite(FillSheets::Yes));
  }

  [[nodiscard]] bool is_too_far_behind_holes() const {
    return is_too_far_ && distance_of_rest_ <= driver_.mesh().max_deviation();
  }
  [[nodiscard]] bool is_too_far() const { return is_too_far_; }
  [[nodiscard]] double distance_behind_holes() const { return distance_behind_holes_; }
  [[nodiscard]] const LostBoundary& far() const { return far_; }
  [[nodiscard]] bool has_shells() const { return !shells_.face_keys.empty(); }

 private:
  /// Tells whether everything that a union changes is to be changed.
  [[nodiscard]] bool may_fix() const {
    return options_.fixes.contains(DefectCode::SelfIntersection) &&
           options_.fixes.contains(DefectCode::Hole) && options_.borders == Borders::Holes &&
           options_.groups == Groups::Names;
  }

  /// Unites the mesh; where many parts of the union touch at a point and cannot be parted, again
  /// with a small solid round it.
  bool unite(FillSheets sheets) {
    sheets_ = sheets;
    joined_.clear();
    is_again_too_far_ = false;
    for (int i = 0; i <= kMostTimesJoined; ++i) {
      touching_.clear();
      if (try_union()) return true;
      if (touching_.empty() || touching_.size() > kMostPointsJoined) break;
      joined_.insert(joined_.end(), touching_.begin(), touching_.end());
    }
    return false;
  }

  bool try_union() {
    SelfUnionOptions how{.fill = options_.fill};
    how.fill.sheets = sheets_;
    if (options_.solid) how.lost = LostParts::Allowed;
    const PlannedPass pass{
        "unite with itself", DefectCode::SelfIntersection, [&](const PassInput& input) {
          // With the same patches it would end as before.
          const bool has_same_patches =
              sheets_ == FillSheets::Yes && !fills_more_with_sheets(input, how.fill);
          if (has_same_patches || is_again_too_far_) return PassResult{};
          PassResult result = self_union(input, how);
          if (!choice_.shells) lost_ = lost_boundary(input, result.edits);
          return result;
        }};
    std::vector<PlannedPass> changes{pass};
    if (!joined_.empty()) {
      changes.push_back({"join at points", DefectCode::SelfIntersection,
                         [&](const PassInput& input) { return join_at_points(input, joined_); }});
    }
    if (choice_.shells) changes.insert(changes.begin(), thickening());
    const bool is_kept = driver_.run_trial(
        {.from_input = plan_before_cutting(options_, tolerances_),
         .changes = std::move(changes),
         .plan = plan_with_contacts_joined(options_, tolerances_),
         .is_wanted = [&](const RepairState& state) { return is_wanted(state); }});
    if (is_kept) driver_.mesh().raise_deviation(distance_);
    return is_kept;
  }

  [[nodiscard]] PlannedPass thickening() {
    return {"thicken parts", DefectCode::Hole, [&](const PassInput& input) {
              sample_whole(input, memory_.boundary);
              lost_ = memory_.boundary.samples;
              shells_ = choose_shells(input, *choice_.shells);
              if (would_be_last_again()) measure_last();
              return thicken_parts(input, shells_.face_keys,
                                   choice_.shells->thickness_share * input.limits.max_deviation);
            }};
  }

  /// Tells whether this union would be the last one without shells again.
  [[nodiscard]] bool would_be_last_again() const {
    return memory_.too_far && memory_.sheets == sheets_ && shells_.face_keys.empty() &&
           choice_.behind_holes == BehindHoles::Kept;
  }

  /// Measures whether the last union without shells is too far from what bounds the solid.
  void measure_last() {
    static_cast<void>(measure_lost(*memory_.too_far));
    is_again_too_far_ = !far_.points.empty();
    is_too_far_ = is_again_too_far_;
  }

  bool is_wanted(const RepairState& state) {
    if (!is_good_in_file(state, tolerances_, check_)) {
      touching_ = contact_points(state.mesh());
      return false;
    }
    is_too_far_ = true;
    const std::vector<double> distances = measure_lost(state);
    // It takes much longer to measure what is not lost. After a lost sample is too far, that
    // matters only if parts behind holes may be dropped, in this union or in one like it later.
    const bool may_be_dropped = !choice_.shells || choice_.behind_holes == BehindHoles::Dropped;
    if (!may_be_dropped && !far_.points.empty()) return false;
    distance_of_rest_ = choice_.shells ? driver_.mesh().measure_deviation_but_for_lost()
                                       : driver_.mesh().measure_deviation();
    add_lost(state, distances);
    distance_ = choice_.behind_holes == BehindHoles::Dropped
                    ? distance_of_rest_
                    : std::max(distance_of_rest_, distance_behind_holes_);
    is_too_far_ = !(distance_ <= driver_.mesh().max_deviation());
    if (is_too_far_ && !choice_.shells) {
      memory_.too_far = driver_.mesh().shared_state();
      memory_.sheets = sheets_;
    }
    return !is_too_far_;
  }

  /// Adds the distances of lost samples to those of what is not lost.
  void add_lost(const RepairState& state, std::span<const double> distances) {
    distance_behind_holes_ = 0.0;
    if (lost_.empty()) return;
    const MeshRegion solid(state.tracked().soup, state.mesh().tree());
    for (std::size_t i = 0; i < lost_.size(); ++i) {
      if (distances[i] <= distance_of_rest_) continue;
      double& largest = solid.contains(lost_[i].point) ? distance_behind_holes_ : distance_of_rest_;
      largest = std::max(largest, distances[i]);
    }
  }

  /// Returns the distance of each lost sample from the result, and notes those that are too far.
  std::vector<double> measure_lost(const RepairState& state) {
    far_ = {};
    const ClosestPoints closest(state.mesh().tree());
    Index hint = kNoIndex;
    std::vector<double> distances;
    distances.reserve(lost_.size());
    for (const BoundarySample& sample : lost_) {
      const auto found = closest.find({.point = sample.point, .hint = hint});
      hint = found->slot;
      distances.push_back(found->distance);
      if (found->distance > driver_.mesh().max_deviation()) note_far(sample);
    }
    sort_unique(far_.face_keys);
    return distances;
  }

  void note_far(const BoundarySample& sample) {
    const Index key = sample.face_key;
    far_.points.push_back(sample.point);
    far_.face_keys.push_back(key);
    far_.has_open = far_.has_open || std::binary_search(shells_.other_open_keys.begin(),
                                                        shells_.other_open_keys.end(), key);
  }

  RepairDriver& driver_;
  const RepairOptions& options_;
  const Tolerances& tolerances_;
  const UnionChoice& choice_;
  UnionMemory& memory_;
  FinalCheck check_;
  /// Whether the holes of sheets are filled.
  FillSheets sheets_ = FillSheets::No;
  /// Samples of what bounded the solid: of the dropped parts of the last union, or with shells of
  /// all of the mesh.
  std::vector<BoundarySample> lost_;
  /// The points at which the last union still touched, and those at which it is joined.
  std::vector<Vec3> touching_;
  std::vector<Vec3> joined_;
  /// The parts that became shells.
  ChosenShells shells_;
  /// Those of the samples that are too far from it.
  LostBoundary far_;
  /// The deviation of the last union that was good.
  double distance_ = 0.0;
  /// The largest distance of samples that lie inside it, and the deviation without them.
  double distance_behind_holes_ = 0.0;
  double distance_of_rest_ = 0.0;
  bool is_too_far_ = false;
  /// Tells whether this union is not made, because it would be the last one, which is too far.
  bool is_again_too_far_ = false;
};

}  // namespace

UnitedFromInput unite_from_input(RepairDriver& driver, const RepairOptions& options,
                                 const Tolerances& tolerances, const UnionChoice& choice,
                                 UnionMemory& memory) {
  UnionFromInput from_input(driver, options, tolerances, choice, memory);
  if (!from_input.run()) {
    return {.note = "",
            .is_too_far_behind_holes = from_input.is_too_far_behind_holes(),
            .is_too_far = from_input.is_too_far(),
            .lost = from_input.far()};
  }
  std::string note =
      "repairs part by part left defects, so the mesh was replaced by its union with itself";
  if (from_input.distance_behind_holes() > driver.mesh().max_deviation()) {
    note += "; parts that lie inside it, because holes are filled, were dropped, " +
            readable(from_input.distance_behind_holes()) + " from its surface at most";
  }
  if (choice.shells) note += "; parts that bound no solid were dropped";
  if (from_input.has_shells()) {
    note += ", and parts that it would have lost or that hid these made hollow, with walls " +
            readable(choice.shells->thickness_share * driver.mesh().max_deviation()) + " thick";
  }
  return {.note = std::move(note)};
}

}  // namespace meshalyzer
