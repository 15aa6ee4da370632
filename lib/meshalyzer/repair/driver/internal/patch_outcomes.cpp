#include "meshalyzer/repair/driver/internal/patch_outcomes.h"

#include "meshalyzer/repair/driver/internal/reason_left.h"

#include <algorithm>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

/// Determines the outcome for each patch.
class OutcomeFinder {
 public:
  OutcomeFinder(const RepairDriver& driver, const DefectReport& before)
      : driver_(driver), part_of_(driver.mesh().input().n_faces(), kNoIndex) {
    for (std::size_t i = 0; i < before.defects.size(); ++i) {
      if (before.defects.code_of(i) != DefectCode::SelfIntersection) continue;
      const Defect defect = before.defects[i];
      for (const Index face : defect.faces) part_of_[face] = static_cast<Index>(outcomes_.size());
      PatchOutcome& outcome = outcomes_.emplace_back();
      outcome.defect = i;
      outcome.is_mended = true;
    }
  }

  std::vector<PatchOutcome> run() {
    if (outcomes_.empty()) return {};
    find_passes();
    find_what_is_left();
    find_reasons();
    const std::vector<double> distances = driver_.mesh().measure_parts(part_of_, outcomes_.size());
    for (std::size_t i = 0; i < outcomes_.size(); ++i) outcomes_[i].distance = distances[i];
    return std::move(outcomes_);
  }

 private:
  /// Returns the outcome of the patch of a face, or of the face it was made of; null if there is
  /// none.
  [[nodiscard]] PatchOutcome* outcome_of(Index face_key) {
    if (face_key == kNoIndex) return nullptr;
    const Index origin = driver_.mesh().tracked().origin_of_key(face_key);
    const Index part = origin == kNoIndex ? kNoIndex : part_of_[origin];
    return part == kNoIndex ? nullptr : &outcomes_[part];
  }

  void find_passes() {
    const RepairLog& log = driver_.log();
    for (const LoggedOperation& operation : log.operations) {
      const std::string& pass = log.steps[operation.step].pass;
      for (const auto* keys :
           {&operation.removed_faces, &operation.changed_faces, &operation.added_faces}) {
        for (const Index key : *keys) add_pass(pass, key);
      }
    }
  }

  void add_pass(const std::string& pass, Index face_key) {
    PatchOutcome* outcome = outcome_of(face_key);
    if (outcome == nullptr) return;
    std::vector<std::string>& passes = outcome->passes;
    if (std::find(passes.begin(), passes.end(), pass) == passes.end()) passes.push_back(pass);
  }

  void find_what_is_left() {
    for (const IntersectingPair& pair : driver_.mesh().prepared().intersecting_pairs()) {
      for (const Index face : {pair.face_a, pair.face_b}) {
        PatchOutcome* outcome = outcome_of(driver_.mesh().tracked().face_keys[face]);
        if (outcome != nullptr) outcome->is_mended = false;
      }
    }
  }

  /// A refusal may name a face of one patch and apply to several connected ones.
  void find_reasons() {
    std::string general = reason_of_defects_left(driver_);
    for (const LoggedRefusal& refusal : driver_.log().refusals) {
      if (refusal.code != DefectCode::SelfIntersection) continue;
      general = refusal.reason;
      PatchOutcome* outcome = outcome_of(refusal.face);
      if (outcome != nullptr && outcome->reason.empty()) outcome->reason = refusal.reason;
    }
    for (PatchOutcome& outcome : outcomes_) {
      if (outcome.is_mended) {
        outcome.reason.clear();
      } else if (outcome.reason.empty()) {
        outcome.reason = general;
      }
    }
  }

  const RepairDriver& driver_;
  /// #faces of the input: the patch that each is in, kNoIndex for none.
  std::vector<Index> part_of_;
  std::vector<PatchOutcome> outcomes_;
};

}  // namespace

std::vector<PatchOutcome> find_patch_outcomes(const RepairDriver& driver,
                                              const DefectReport& before) {
  return OutcomeFinder(driver, before).run();
}

}  // namespace meshalyzer
