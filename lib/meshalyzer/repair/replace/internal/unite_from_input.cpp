#include "meshalyzer/repair/replace/internal/unite_from_input.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/contour/boundary_samples.h"
#include "meshalyzer/contour/mesh_region.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/replace/internal/broken_solids.h"
#include "meshalyzer/spatial/closest_point.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The sides of a dropped piece are examined at this distance, as a share of the maximum deviation.
constexpr double kSideReach = 1.0 / 16.0;

/// Returns samples of those removed parts of the mesh that bound its solid.
std::vector<Vec3> lost_boundary(const PassInput& input, const Edits& edits) {
  std::vector<Corners> pieces;
  pieces.reserve(edits.interior_walls.size());
  for (const auto& removed : edits.interior_walls) pieces.push_back(removed.wall.corners);
  return sample_boundary(input.tracked.soup, pieces, kSideReach * input.limits.max_deviation);
}

class UnionFromInput {
 public:
  UnionFromInput(RepairDriver& driver, const RepairOptions& options, const Tolerances& tolerances,
                 BehindHoles behind_holes)
      : driver_(driver),
        options_(options),
        tolerances_(tolerances),
        behind_holes_(behind_holes),
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
  [[nodiscard]] double distance_behind_holes() const { return distance_behind_holes_; }

 private:
  /// Tells whether everything that a union changes is to be changed.
  [[nodiscard]] bool may_fix() const {
    return options_.fixes.contains(DefectCode::SelfIntersection) &&
           options_.fixes.contains(DefectCode::Hole) && options_.borders == Borders::Holes &&
           options_.groups == Groups::Names;
  }

  bool unite(FillSheets sheets) {
    SelfUnionOptions how{.fill = options_.fill};
    how.fill.sheets = sheets;
    if (options_.solid) how.lost = LostParts::Allowed;
    const PlannedPass pass{"unite with itself", DefectCode::SelfIntersection,
                           [&](const PassInput& input) {
                             PassResult result = self_union(input, how);
                             lost_ = lost_boundary(input, result.edits);
                             return result;
                           }};
    const bool is_kept = driver_.run_trial(
        {.from_input = plan_before_cutting(options_, tolerances_),
         .change = pass,
         .plan = plan_with_contacts_joined(options_, tolerances_),
         .is_wanted = [&](const RepairState& state) { return is_wanted(state); }});
    if (is_kept) driver_.mesh().raise_deviation(distance_);
    return is_kept;
  }

  bool is_wanted(const RepairState& state) {
    if (!is_good_in_file(state, tolerances_, check_)) return false;
    distance_of_rest_ = driver_.mesh().measure_deviation();
    distance_behind_holes_ = 0.0;
    measure_lost(state);
    distance_ = behind_holes_ == BehindHoles::Dropped
                    ? distance_of_rest_
                    : std::max(distance_of_rest_, distance_behind_holes_);
    is_too_far_ = !(distance_ <= driver_.mesh().max_deviation());
    return !is_too_far_;
  }

  /// Measures how far the lost samples are from the result.
  void measure_lost(const RepairState& state) {
    if (lost_.empty()) return;
    const Soup& result = state.tracked().soup;
    const MeshRegion solid(result, state.mesh().tree());
    const ClosestPoints closest(state.mesh().tree());
    Index hint = kNoIndex;
    for (const Vec3& point : lost_) {
      const auto found = closest.find({.point = point, .hint = hint});
      hint = found->slot;
      if (found->distance <= distance_of_rest_) continue;
      double& largest = solid.contains(point) ? distance_behind_holes_ : distance_of_rest_;
      largest = std::max(largest, found->distance);
    }
  }

  RepairDriver& driver_;
  const RepairOptions& options_;
  const Tolerances& tolerances_;
  BehindHoles behind_holes_;
  FinalCheck check_;
  /// Samples of the dropped parts of the last union that bounded the solid.
  std::vector<Vec3> lost_;
  /// The deviation of the last union that was good.
  double distance_ = 0.0;
  /// The largest distance of samples that lie inside it, and the deviation without them.
  double distance_behind_holes_ = 0.0;
  double distance_of_rest_ = 0.0;
  bool is_too_far_ = false;
};

}  // namespace

UnitedFromInput unite_from_input(RepairDriver& driver, const RepairOptions& options,
                                 const Tolerances& tolerances, BehindHoles behind_holes) {
  UnionFromInput from_input(driver, options, tolerances, behind_holes);
  if (!from_input.run()) {
    return {.note = "", .is_too_far_behind_holes = from_input.is_too_far_behind_holes()};
  }
  std::string note =
      "repairs part by part left defects, so the mesh was replaced by its union with itself";
  if (from_input.distance_behind_holes() > driver.mesh().max_deviation()) {
    note += "; parts that lie inside it, because holes are filled, were dropped, " +
            readable(from_input.distance_behind_holes()) + " from its surface at most";
  }
  return {.note = std::move(note)};
}

}  // namespace meshalyzer
