#pragma once

#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/repair/driver/deviation.h"
#include "meshalyzer/repair/driver/internal/acceptance.h"
#include "meshalyzer/repair/driver/internal/plan.h"
#include "meshalyzer/repair/driver/internal/repair_state.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

/// A mesh that is edited, and its distance from the input that it was made of.
///
/// Edits are tried on a copy, checked, and then kept or forgotten. It can return to an earlier
/// state.
class MeasuredMesh {
 public:
  /// @param max_deviation  The distance from the input that checked edits must keep. A length.
  /// @param pairs          The limits of each search of the whole mesh for intersecting pairs; only
  ///                       the first one is stopped by its function.
  MeasuredMesh(Soup input, const Tolerances& tolerances, double max_deviation, PairLimits pairs);
  MeasuredMesh(const MeasuredMesh&) = delete;
  MeasuredMesh& operator=(const MeasuredMesh&) = delete;

  /// Returns the mesh before all edits.
  [[nodiscard]] const Soup& input() const { return input_; }
  [[nodiscard]] const RepairState& state() const { return *state_; }
  [[nodiscard]] const TrackedMesh& tracked() const { return state_->tracked(); }
  [[nodiscard]] const PreparedMesh& prepared() const { return state_->mesh(); }
  /// Returns the prepared mesh for use after the end of this.
  [[nodiscard]] std::shared_ptr<const PreparedMesh> shared_prepared() const {
    return {state_, &state_->mesh()};
  }
  /// Returns a number above 0 that no other mesh has had which this has held.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// Returns the state for use after later edits.
  [[nodiscard]] std::shared_ptr<const RepairState> shared_state() const { return state_; }
  [[nodiscard]] const Tolerances& tolerances() const { return tolerances_; }
  [[nodiscard]] double max_deviation() const { return max_deviation_; }
  /// Returns the largest number of intersecting pairs that is searched for.
  [[nodiscard]] std::size_t max_pairs() const { return max_pairs_; }

  /// Returns an upper bound of the distance between the input and the mesh, hole patches left out.
  /// It is measured when it is asked for.
  [[nodiscard]] double deviation();
  /// Measures this distance even if it may be larger than the maximum, after edits that were
  /// applied unchecked; what these have lost counts too.
  double measure_deviation();
  /// Measures it without the faces of the input that these edits have lost, which the caller has to
  /// judge.
  double measure_deviation_but_for_lost();
  /// Notes a deviation that was measured outside.
  void raise_deviation(double deviation);
  /// Measures parts of the input as DeviationMeter::measure_parts() does.
  [[nodiscard]] std::vector<double> measure_parts(std::span<const Index> part_of,
                                                  std::size_t n_parts) const;

  /// The mesh after edits that are tried.
  struct Trial {
    std::shared_ptr<const RepairState> after;
    AffectedElements affected;
    /// The walls that are removed then.
    std::vector<InteriorWall> walls;
  };

  /// Applies edits to a copy.
  ///
  /// @param skipped       #operations: non-zero for those that are left out.
  /// @param tried_before  The result of the same edits with fewer operations left out, if they were
  ///                      tried; it saves searches.
  [[nodiscard]] Trial try_edits(const Edits& edits, std::span<const std::uint8_t> skipped,
                                const RepairState* tried_before = nullptr) const;
  /// Checks the operations of edits that are tried.
  ///
  /// @param pass  The pass that has proposed them.
  [[nodiscard]] Acceptance check(const Trial& trial, std::size_t n_operations,
                                 const PlannedPass& pass) const;
  /// Keeps edits all of whose operations were accepted.
  void keep(Trial trial, const Edits& edits);
  /// Applies edits without checking them.
  ///
  /// @param wants_to_stop  Once it says yes, what they have lost is not measured any more, and they
  ///                       are to be undone.
  /// @return               The elements that they have affected.
  AffectedElements apply_unchecked(const Edits& edits, const StopQuery& wants_to_stop = {});

  /// A state that the mesh can return to.
  struct Snapshot {
    TrackedMesh tracked;
    /// Its intersecting pairs, if all of them are known.
    std::optional<std::vector<IntersectingPair>> pairs;
    double deviation = 0.0;
    bool is_within = true;
    std::vector<InteriorWall> walls;
    std::vector<Index> lost;
  };

  [[nodiscard]] Snapshot snapshot();
  void restore(const Snapshot& snapshot);
  void return_to_input();
  /// Notes the intersecting pairs of the input, for return_to_input(). It may be called before the
  /// first edit only.
  void note_input_pairs() { input_pairs_ = known_pairs(); }

 private:
  [[nodiscard]] std::optional<std::vector<IntersectingPair>> known_pairs() const;
  [[nodiscard]] std::shared_ptr<const RepairState> search_all(TrackedMesh tracked) const;
  [[nodiscard]] std::vector<InteriorWall> walls_with(const Edits& edits,
                                                     std::span<const std::uint8_t> skipped) const;
  [[nodiscard]] double measure_without(std::span<const Index> lost) const;
  /// Measures the deviation if it is not known.
  void update_deviation();
  /// Finds the faces that edits that were applied unchecked have lost.
  void find_lost_faces(const StopQuery& wants_to_stop);
  /// Lets later edits lie on the hole patches that these edits have added.
  void include_patches(const Edits& edits);
  void replace_state(std::shared_ptr<const RepairState> state);

  Soup input_;
  /// The intersecting pairs of the input, if all are known.
  std::optional<std::vector<IntersectingPair>> input_pairs_;
  Tolerances tolerances_;
  double max_deviation_;
  std::size_t max_pairs_;
  std::optional<DeviationMeter> meter_;
  std::shared_ptr<const RepairState> state_;
  std::size_t number_ = 1;
  /// The parts of the surface that separated no inside from no outside and were removed.
  std::vector<InteriorWall> walls_;
  /// The faces of the input that edits that were applied unchecked have left beyond the maximum
  /// deviation, ascending. Whoever wanted these edits judges them; no operation after them is
  /// rejected because of these faces.
  std::vector<Index> lost_;
  /// The deviation when it was last measured.
  double deviation_ = 0.0;
  bool is_deviation_known_ = true;
  /// Tells whether no face of the input that is not lost, and no face of the mesh, is farther from
  /// the other than the maximum deviation. Edits that were applied unchecked may have taken some
  /// farther.
  bool is_within_ = true;
};

}  // namespace meshalyzer
