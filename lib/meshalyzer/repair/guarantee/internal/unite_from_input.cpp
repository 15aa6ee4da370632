#include "meshalyzer/repair/guarantee/internal/unite_from_input.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/contour/mesh_region.h"
#include "meshalyzer/repair/holes/internal/crossing_patches.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/replace/internal/broken_solids.h"
#include "meshalyzer/repair/replace/internal/join_points.h"
#include "meshalyzer/repair/replace/internal/offset_parts.h"
#include "meshalyzer/repair/replace/internal/thicken_parts.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
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
/// Where so many pairs of faces touch at these few points, dozens of parts meet there: to join them
/// after they were parted takes long, and mostly fails.
constexpr std::size_t kManyContacts = 1000;

/// Returns the pieces of faces that were removed as walls inside the solid. Patches are no faces of
/// the mesh.
FacePieces removed_walls(const TrackedMesh& mesh, const Edits& edits) {
  FacePieces walls;
  for (const auto& removed : edits.interior_walls) {
    if (removed.wall.face == kNoIndex) continue;
    walls.corners.push_back(removed.wall.corners);
    walls.face_keys.push_back(mesh.face_keys[removed.wall.face]);
  }
  return walls;
}

/// Returns all faces of a mesh that are in its complex.
FacePieces whole_faces(const PassInput& input) {
  FacePieces faces;
  for (const Index face : input.mesh.cut().side.faces) {
    faces.corners.push_back(corners_of(input.tracked.soup, face));
    faces.face_keys.push_back(input.tracked.face_keys[face]);
  }
  return faces;
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
  UnionFromInput(RepairDriver& driver, const RepairOptions& options, const UnionChoice& choice,
                 UnionMemory& memory)
      : driver_(driver),
        options_(options),
        tolerances_(driver.mesh().tolerances()),
        choice_(choice),
        memory_(memory) {}

  UnitedFromInput run() {
    if (!choice_.shells) memory_.with_parts_dropped.reset();
    if (!may_unite()) return {};
    // A patch over a sheet encloses a region that the sheet does not mean as a solid, so that is
    // tried last.
    if (unite(FillSheets::No) || (options_.solid && !is_too_far_ && unite(FillSheets::Yes))) {
      return {.note = what_was_done()};
    }
    return {.note = "", .is_too_far = is_too_far_, .lost = std::move(far_)};
  }

 private:
  [[nodiscard]] bool may_unite() const {
    if (!may_fix() || driver_.is_stopped() || !(driver_.mesh().max_deviation() > 0.0)) return false;
    if (driver_.is_good(driver_.mesh().state())) return false;
    const BrokenSolid whole = whole_mesh_as_solid(driver_.mesh().prepared());
    return options_.solid ? whole.any_bounds_solid : whole.all_bound_solid;
  }

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
    has_left_contacts_ = false;
    for (int i = 0; i <= kMostTimesJoined; ++i) {
      touching_.clear();
      may_leave_contacts_ = i < kMostTimesJoined;
      if (try_union()) return true;
      if (touching_.empty() || touching_.size() > kMostPointsJoined) break;
      joined_.insert(joined_.end(), touching_.begin(), touching_.end());
    }
    if (!has_left_contacts_ || is_too_far_) return false;
    // A rod at each point did not suffice, so that the contacts left are joined after all.
    joined_.clear();
    may_leave_contacts_ = false;
    return try_union();
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
          if (!choice_.changes_parts()) {
            remember(input);
            losable_ = removed_walls(input.tracked, result.edits);
          }
          return result;
        }};
    std::vector<PlannedPass> changes{pass};
    if (!joined_.empty()) {
      changes.push_back({"join at points", DefectCode::SelfIntersection,
                         [&](const PassInput& input) { return join_at_points(input, joined_); }});
    }
    if (choice_.offset_share > 0.0) changes.insert(changes.begin(), moving_outward());
    if (choice_.shells) changes.insert(changes.begin(), thickening());
    const bool is_kept = driver_.run_trial(
        {.from_input = plan_before_cutting(options_, tolerances_),
         .changes = std::move(changes),
         .plan = plan_after_union(),
         .is_wanted = [&](const RepairState& state) { return is_wanted(state); }});
    if (is_kept) driver_.mesh().raise_deviation(distance_);
    return is_kept;
  }

  /// Returns the passes after a union. They leave what touches at a few points if these can be
  /// joined before anything is parted, in the next union.
  [[nodiscard]] std::vector<PlannedPass> plan_after_union() {
    std::vector<PlannedPass> plan = plan_passes(options_, tolerances_);
    for (PlannedPass& pass : plan_to_join_contacts(options_)) {
      pass.run = [this, join = std::move(pass.run)](const PassInput& input) {
        return leaves_contacts(input) ? PassResult{} : join(input);
      };
      plan.push_back(std::move(pass));
    }
    return plan;
  }

  bool leaves_contacts(const PassInput& input) {
    const std::size_t n_pairs = input.mesh.intersecting_pairs().size();
    if (!may_leave_contacts_ || n_pairs < kManyContacts) return false;
    const std::size_t n_points = contact_points(input.tracked, input.mesh).size();
    const bool leaves = n_points != 0 && n_points <= kMostPointsJoined;
    has_left_contacts_ = has_left_contacts_ || leaves;
    return leaves;
  }

  [[nodiscard]] PlannedPass moving_outward() {
    return {"move outward", DefectCode::SelfIntersection, [&](const PassInput& input) {
              if (!choice_.shells) remember_all(input);
              return offset_parts(input, choice_.offset_share * input.limits.max_deviation);
            }};
  }

  [[nodiscard]] PlannedPass thickening() {
    return {"thicken parts", DefectCode::Hole, [&](const PassInput& input) {
              remember_all(input);
              shells_ = choose_shells(input, *choice_.shells);
              if (would_be_last_again()) measure_last();
              return thicken_parts(input, shells_.face_keys, choice_.shells->separable_keys,
                                   choice_.shells->thickness_share * input.limits.max_deviation);
            }};
  }

  /// Remembers the mesh before its parts are changed, all of which may be lost.
  void remember_all(const PassInput& input) {
    remember(input);
    losable_ = whole_faces(input);
  }

  /// Remembers the mesh that is replaced, unless it is the one that was replaced before.
  void remember(const PassInput& input) {
    if (memory_.replaced && memory_.replaced->is(input.tracked)) return;
    memory_.replaced = std::make_shared<const ReplacedMesh>(
        input.tracked, kSideReach * input.limits.max_deviation);
  }

  /// Tells whether this union would be the last one without shells again.
  [[nodiscard]] bool would_be_last_again() const {
    return memory_.too_far && memory_.sheets == sheets_ && shells_.face_keys.empty() &&
           choice_.behind_holes == BehindHoles::Kept;
  }

  /// Measures whether the last union without shells is too far from what bounds the solid.
  void measure_last() {
    note_far(measure_loss(*memory_.too_far).beyond_limit());
    is_again_too_far_ = !far_.points.empty();
    is_too_far_ = is_again_too_far_;
  }

  bool is_wanted(const RepairState& state) {
    if (!driver_.is_good(state)) {
      touching_ = contact_points(state.tracked(), state.mesh());
      return false;
    }
    is_too_far_ = true;
    const BoundaryLoss loss = measure_loss(state);
    const std::vector<BoundarySample> far = loss.beyond_limit();
    note_far(far);
    // It takes much longer to measure what is not lost. After a lost sample is too far, that
    // matters only if parts behind holes may be dropped, in this union or after all.
    const bool may_be_dropped = !choice_.shells || choice_.behind_holes == BehindHoles::Dropped;
    if (!may_be_dropped && !far.empty()) return false;
    distance_of_rest_ = choice_.changes_parts() ? driver_.mesh().measure_deviation_but_for_lost()
                                                : driver_.mesh().measure_deviation();
    add_loss(state, loss, far);
    distance_ = choice_.behind_holes == BehindHoles::Dropped
                    ? distance_of_rest_
                    : std::max(distance_of_rest_, distance_behind_holes_);
    is_too_far_ = !(distance_ <= driver_.mesh().max_deviation());
    if (is_too_far_ && !choice_.shells) remember_too_far();
    return !is_too_far_;
  }

  /// Remembers a union without shells that is too far from the input.
  void remember_too_far() {
    memory_.too_far = driver_.mesh().shared_state();
    memory_.sheets = sheets_;
    if (distance_of_rest_ <= driver_.mesh().max_deviation()) {
      memory_.with_parts_dropped =
          RejectedUnion{driver_.checkpoint(), distance_of_rest_, what_was_done()};
    }
  }

  [[nodiscard]] BoundaryLoss measure_loss(const RepairState& state) const {
    return {memory_.replaced, losable_, state.mesh().tree(), driver_.mesh().max_deviation()};
  }

  /// Adds the distances of lost samples to those of what is not lost.
  void add_loss(const RepairState& state, const BoundaryLoss& loss,
                std::span<const BoundarySample> far) {
    distance_behind_holes_ = 0.0;
    std::optional<MeshRegion> solid;
    const auto is_inside = [&](const Vec3& point) {
      if (!solid) solid.emplace(state.tracked().soup, state.mesh().tree());
      return solid->contains(point);
    };
    for (const BoundarySample& sample : far) {
      double& largest = is_inside(sample.point) ? distance_behind_holes_ : distance_of_rest_;
      largest = std::max(largest, sample.distance);
    }
    // Once a lost part inside is too far, the union is of use only if such parts may be dropped.
    const bool all_count =
        choice_.behind_holes == BehindHoles::Kept && !(distance_behind_holes_ > 0.0);
    distance_of_rest_ = loss.largest_within_limit(
        distance_of_rest_, [&](const Vec3& point) { return all_count || !is_inside(point); });
  }

  /// Notes the lost samples that are too far away.
  void note_far(std::span<const BoundarySample> samples) {
    far_ = {};
    for (const BoundarySample& sample : samples) {
      far_.points.push_back(sample.point);
      far_.face_keys.push_back(sample.face_key);
      far_.has_open =
          far_.has_open || std::binary_search(shells_.other_open_keys.begin(),
                                              shells_.other_open_keys.end(), sample.face_key);
    }
    sort_unique(far_.face_keys);
    std::set_intersection(far_.face_keys.begin(), far_.face_keys.end(), shells_.face_keys.begin(),
                          shells_.face_keys.end(), std::back_inserter(far_.shell_keys));
  }

  [[nodiscard]] std::string what_was_done() const {
    std::string note =
        "repairs part by part left defects, so the mesh was replaced by its union with itself";
    const double max_deviation = driver_.mesh().max_deviation();
    if (distance_behind_holes_ > max_deviation) {
      note += "; parts that lie inside it, because holes are filled, were dropped, " +
              readable(distance_behind_holes_) + " from its surface at most";
    }
    if (choice_.changes_parts()) note += "; parts that bound no solid were dropped";
    if (!shells_.face_keys.empty()) {
      note += ", and parts that it would have lost or that hid these made hollow, with walls " +
              readable(choice_.shells->thickness_share * max_deviation) + " thick";
    }
    if (choice_.offset_share > 0.0) {
      const double least = choice_.offset_share * max_deviation;
      note += "; before that, each broken part was moved outward, by " + readable(least) + " to " +
              readable(2.0 * least) + ", so that walls that touched overlap";
    }
    return note;
  }

  RepairDriver& driver_;
  const RepairOptions& options_;
  const Tolerances& tolerances_;
  const UnionChoice& choice_;
  UnionMemory& memory_;
  /// Whether the holes of sheets are filled.
  FillSheets sheets_ = FillSheets::No;
  /// What the last union may have lost: the walls that it has removed, or all faces if parts were
  /// moved or made shells before.
  FacePieces losable_;
  /// The points at which the last union still touched, and those at which it is joined.
  std::vector<Vec3> touching_;
  std::vector<Vec3> joined_;
  /// Whether the present union may leave contacts to the next one, and whether one of them did.
  bool may_leave_contacts_ = false;
  bool has_left_contacts_ = false;
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
                                 const UnionChoice& choice, UnionMemory& memory) {
  return UnionFromInput(driver, options, choice, memory).run();
}

}  // namespace meshalyzer
