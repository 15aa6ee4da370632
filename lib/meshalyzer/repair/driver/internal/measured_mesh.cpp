#include "meshalyzer/repair/driver/internal/measured_mesh.h"

#include "meshalyzer/repair/edits/apply_edits.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {

MeasuredMesh::MeasuredMesh(Soup input, const Tolerances& tolerances, double max_deviation,
                           PairLimits pairs)
    : input_(std::move(input)),
      tolerances_(tolerances),
      max_deviation_(max_deviation),
      max_pairs_(pairs.max_found),
      meter_(std::in_place, input_),
      state_(std::make_shared<RepairState>(track_mesh(input_), tolerances_, std::move(pairs))) {}

void MeasuredMesh::update_deviation() {
  if (is_deviation_known_) return;
  // All that was kept was found to be within the maximum.
  deviation_ = std::min(measure_without(lost_), max_deviation_);
  is_deviation_known_ = true;
}

double MeasuredMesh::deviation() {
  update_deviation();
  return deviation_;
}

double MeasuredMesh::measure_deviation() {
  deviation_ = measure_without({});
  is_deviation_known_ = true;
  return deviation_;
}

double MeasuredMesh::measure_deviation_but_for_lost() {
  deviation_ = measure_without(lost_);
  is_deviation_known_ = true;
  return deviation_;
}

double MeasuredMesh::measure_without(std::span<const Index> lost) const {
  return meter_
      ->measure({.tracked = tracked(),
                 .mesh = prepared(),
                 .bound = max_deviation_,
                 .walls = walls_,
                 .lost = lost})
      .largest;
}

void MeasuredMesh::raise_deviation(double deviation) {
  deviation_ = std::max(this->deviation(), deviation);
}

std::vector<double> MeasuredMesh::measure_parts(std::span<const Index> part_of,
                                                std::size_t n_parts) const {
  return meter_->measure_parts({tracked(), prepared(), max_deviation_, walls_}, part_of, n_parts);
}

MeasuredMesh::Trial MeasuredMesh::try_edits(const Edits& edits,
                                            std::span<const std::uint8_t> skipped,
                                            const RepairState* tried_before) const {
  TrackedMesh after = apply_edits(tracked(), edits, skipped);
  AffectedElements affected =
      find_affected_elements(tracked(), edits, SkippedOperations(skipped), after);
  auto state = std::make_shared<RepairState>(
      std::move(after), tolerances_, RepairState::KnownStates{*state_, tried_before}, affected);
  return {std::move(state), std::move(affected), walls_with(edits, skipped)};
}

Acceptance MeasuredMesh::check(const Trial& trial, std::size_t n_operations,
                               const PlannedPass& pass) const {
  return check_acceptance(*state_, *trial.after, trial.affected, n_operations,
                          {.input = input_,
                           .meter = *meter_,
                           .max_deviation = max_deviation_,
                           .may_create = pass.may_create,
                           .must_mend = pass.must_mend,
                           .walls = trial.walls,
                           .lost = lost_,
                           .was_within = is_within_});
}

void MeasuredMesh::keep(Trial trial, const Edits& edits) {
  replace_state(std::move(trial.after));
  walls_ = std::move(trial.walls);
  is_deviation_known_ = false;
  is_within_ = true;
  include_patches(edits);
}

AffectedElements MeasuredMesh::apply_unchecked(const Edits& edits, const StopQuery& wants_to_stop) {
  // Edits that are not checked are not measured either: the deviation stays as it was before.
  update_deviation();
  TrackedMesh after = apply_edits(tracked(), edits);
  AffectedElements affected =
      find_affected_elements(tracked(), edits, SkippedOperations({}), after);
  walls_ = walls_with(edits, std::vector<std::uint8_t>(edits.n_operations, 0));
  replace_state(search_all(std::move(after)));
  include_patches(edits);
  find_lost_faces(wants_to_stop);
  return affected;
}

void MeasuredMesh::find_lost_faces(const StopQuery& wants_to_stop) {
  FarFaces far = meter_->find_far({.tracked = tracked(),
                                   .mesh = prepared(),
                                   .bound = max_deviation_,
                                   .walls = walls_,
                                   .wants_to_stop = wants_to_stop});
  lost_ = std::move(far.of_input);
  is_within_ = far.of_repaired.empty();
}

std::vector<InteriorWall> MeasuredMesh::walls_with(const Edits& edits,
                                                   std::span<const std::uint8_t> skipped) const {
  std::vector<InteriorWall> walls = walls_;
  for (const auto& [op, wall] : edits.interior_walls) {
    if (skipped[op] != 0) continue;
    const Index origin = wall.face == kNoIndex ? kNoIndex : tracked().origin_of_face(wall.face);
    walls.push_back({wall.corners, origin});
  }
  return walls;
}

void MeasuredMesh::include_patches(const Edits& edits) {
  const bool has_patches = std::any_of(edits.added_faces.begin(), edits.added_faces.end(),
                                       [](const auto& face) { return face.fills_hole; });
  if (has_patches) meter_->include_patches(tracked());
}

void MeasuredMesh::replace_state(std::shared_ptr<const RepairState> state) {
  state_ = std::move(state);
  ++number_;
}

MeasuredMesh::Snapshot MeasuredMesh::snapshot() {
  return {tracked(), known_pairs(), deviation(), is_within_, walls_, lost_};
}

void MeasuredMesh::restore(const Snapshot& snapshot) {
  meter_.emplace(input_);
  replace_state(snapshot.pairs
                    ? std::make_shared<RepairState>(snapshot.tracked, tolerances_, *snapshot.pairs)
                    : search_all(snapshot.tracked));
  meter_->include_patches(tracked());
  deviation_ = snapshot.deviation;
  is_within_ = snapshot.is_within;
  walls_ = snapshot.walls;
  lost_ = snapshot.lost;
  is_deviation_known_ = true;
}

void MeasuredMesh::return_to_input() {
  restore({.tracked = track_mesh(input_), .pairs = input_pairs_, .walls = {}, .lost = {}});
}

std::shared_ptr<const RepairState> MeasuredMesh::search_all(TrackedMesh tracked) const {
  return std::make_shared<RepairState>(std::move(tracked), tolerances_,
                                       PairLimits{.max_found = max_pairs_, .wants_to_stop = {}});
}

std::optional<std::vector<IntersectingPair>> MeasuredMesh::known_pairs() const {
  const std::vector<IntersectingPair>& pairs = prepared().intersecting_pairs();
  if (prepared().was_intersection_search_cut()) return std::nullopt;
  return pairs;
}

}  // namespace meshalyzer
