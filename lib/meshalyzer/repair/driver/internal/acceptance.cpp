#include "meshalyzer/repair/driver/internal/acceptance.h"

#include "meshalyzer/base/box.h"
#include "meshalyzer/base/corners.h"
#include "meshalyzer/repair/driver/internal/changed_places.h"
#include "meshalyzer/repair/driver/internal/prior_contacts.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>

namespace meshalyzer {
namespace {

std::vector<DefectiveElement> difference(const std::vector<DefectiveElement>& a,
                                         const std::vector<DefectiveElement>& b) {
  std::vector<DefectiveElement> result;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

/// Returns the step that operations make.
SurfaceStep step_between(const RepairState& before, const RepairState& after,
                         const AffectedElements& affected) {
  SurfaceStep step;
  for (const Index key : after.tracked().face_keys) {
    step.is_new.push_back(operations_on(affected.faces_after, key).empty() ? 0 : 1);
  }
  const TrackedMesh& tracked = before.tracked();
  for (Index face = 0; face < tracked.soup.n_faces(); ++face) {
    const bool is_gone = !operations_on(affected.faces_before, tracked.face_keys[face]).empty();
    if (is_gone && is_in_complex(tracked.soup.triangles[face])) {
      step.gone.push_back(corners_of(tracked.soup, face));
    }
  }
  return step;
}

class AcceptanceCheck {
 public:
  AcceptanceCheck(const RepairState& before, const RepairState& after,
                  const AffectedElements& affected, const AcceptanceRules& rules,
                  std::vector<Rejection>& rejections)
      : before_(before),
        after_(after),
        affected_(affected),
        rules_(rules),
        rejections_(rejections) {}

  void check_deviation(const FarFaces& far) {
    for (const Index face : far.of_repaired) {
      reject(operations_on(affected_.faces_after, after_.tracked().face_keys[face]),
             Rejection::TooFar);
    }
    if (far.of_input.empty()) return;
    const ChangedPlaces places(before_.tracked(), affected_);
    for (const Index face : far.of_input) {
      std::vector<Index> operations = places.on(face);
      if (operations.empty()) operations = places.near(surroundings_of(face));
      for (const Index op : operations) rejections_[op] = Rejection::TooFar;
      if (!operations.empty()) continue;
      std::fill(rejections_.begin(), rejections_.end(), Rejection::TooFar);
    }
  }

  /// Rejects operations that bring their faces into contact with faces that they were not in
  /// contact with before. Contact may pass from one face of an operation to another.
  void check_contacts() {
    if (after_.affected_pairs().empty()) return;
    const PriorContacts known(before_, affected_);
    const std::vector<IntersectingPair>& pairs = after_.affected_pairs();
    const std::vector<ContactByKey> contacts = contacts_by_key(after_, pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const ContactByKey& pair = contacts[i];
      if (may_be_made(pairs[i]) || known.were_in_contact(pair)) continue;
      reject_for_contact(pair.face_a, pair.face_b, pair.kind, known);
      reject_for_contact(pair.face_b, pair.face_a, pair.kind, known);
    }
  }

  void check_defects() {
    balance_.assign(rejections_.size(), {});
    count(difference(after_.defective_elements(), before_.defective_elements()), 1);
    count(difference(before_.defective_elements(), after_.defective_elements()), -1);
    for (std::size_t op = 0; op < rejections_.size(); ++op) {
      for (const DefectCode code : all_defect_codes()) {
        if (balance_[op][static_cast<std::size_t>(code)] > 0 && !rules_.may_create.contains(code)) {
          rejections_[op] = Rejection::MoreDefects;
        }
      }
    }
  }

  /// Rejects operations that make fewer neither of the intersecting pairs nor of the border edges;
  /// to be called after check_defects(). Others would undo what they have changed besides, and so
  /// on for ever.
  void check_progress() {
    std::vector<int> balance(rejections_.size(), 0);
    count_pairs(before_, before_.mesh().intersecting_pairs(), affected_.faces_before, -1, balance);
    count_pairs(after_, after_.affected_pairs(), affected_.faces_after, 1, balance);
    // Operations that are skipped affect no vertex.
    for (const AffectedElement& entry : affected_.vertices) {
      const std::size_t op = entry.operation;
      const int borders = balance_[op][static_cast<std::size_t>(DefectCode::Hole)];
      if (balance[op] >= 0 && borders >= 0) rejections_[op] = Rejection::MendsNothing;
    }
  }

 private:
  /// Tells whether a contact is one of copies at the same places, and these may touch.
  [[nodiscard]] bool may_be_made(const IntersectingPair& pair) const {
    if (!rules_.may_create.contains(DefectCode::SelfIntersection)) return false;
    return pair.kind == ContactKind::Unwelded ||
           have_equal_corners(after_.tracked().soup, pair.face_a, pair.face_b);
  }

  void reject(std::span<const AffectedElement> entries, Rejection rejection) {
    for (const AffectedElement& entry : entries) rejections_[entry.operation] = rejection;
  }

  /// Rejects the operations that affect a face for its contact with another.
  void reject_for_contact(Index face, Index other, ContactKind kind, const PriorContacts& known) {
    for (const AffectedElement& entry : operations_on(affected_.faces_after, face)) {
      if (!known.was_in_contact(entry.operation, other, kind)) {
        rejections_[entry.operation] = Rejection::Intersects;
      }
    }
  }

  /// Returns the box round a face of the input in which operations may have lost it: an earlier
  /// pass has removed it.
  [[nodiscard]] Box3 surroundings_of(Index input_face) const {
    return grown(box_of_face(rules_.input, input_face), rules_.max_deviation);
  }

  /// Adds `by` for each pair to the balance of the operations that affect either of its faces.
  static void count_pairs(const RepairState& state, const std::vector<IntersectingPair>& pairs,
                          const std::vector<AffectedElement>& faces, int by,
                          std::vector<int>& balance) {
    const std::vector<Index>& keys = state.tracked().face_keys;
    for (const IntersectingPair& pair : pairs) {
      const auto of_a = operations_on(faces, keys[pair.face_a]);
      const auto of_b = operations_on(faces, keys[pair.face_b]);
      for (const AffectedElement& entry : of_a) balance[entry.operation] += by;
      for (const AffectedElement& entry : of_b) {
        const bool is_counted = std::any_of(
            of_a.begin(), of_a.end(),
            [&](const AffectedElement& other) { return other.operation == entry.operation; });
        if (!is_counted) balance[entry.operation] += by;
      }
    }
  }

  /// Adds `by` for each element to the balance of the operations that affect all of its keys.
  void count(const std::vector<DefectiveElement>& defective_elements, int by) {
    for (const DefectiveElement& element : defective_elements) {
      const auto code = static_cast<std::size_t>(element.code);
      if (element.element == DefectiveElement::Element::Face) {
        const auto& faces = by > 0 ? affected_.faces_after : affected_.faces_before;
        for (const AffectedElement& entry : operations_on(faces, element.keys[0])) {
          balance_[entry.operation][code] += by;
        }
        continue;
      }
      for (const AffectedElement& entry : operations_on(affected_.vertices, element.keys[0])) {
        const AffectedElement other{element.keys[1], entry.operation};
        if (element.element == DefectiveElement::Element::Vertex ||
            std::binary_search(affected_.vertices.begin(), affected_.vertices.end(), other)) {
          balance_[entry.operation][code] += by;
        }
      }
    }
  }

  const RepairState& before_;
  const RepairState& after_;
  const AffectedElements& affected_;
  const AcceptanceRules& rules_;
  std::vector<Rejection>& rejections_;
  /// Indexed by operation and code: the number of defective elements created less the number
  /// removed.
  std::vector<std::array<int, kDefectCodes>> balance_;
};

}  // namespace

bool Acceptance::all_accepted() const {
  return std::all_of(rejections.begin(), rejections.end(),
                     [](Rejection rejection) { return rejection == Rejection::None; });
}

Acceptance check_acceptance(const RepairState& before, const RepairState& after,
                            const AffectedElements& affected, std::size_t n_operations,
                            const AcceptanceRules& rules) {
  Acceptance acceptance;
  acceptance.rejections.assign(n_operations, Rejection::None);
  AcceptanceCheck check(before, after, affected, rules, acceptance.rejections);
  check.check_defects();
  if (rules.must_mend) check.check_progress();
  check.check_contacts();
  // Distances take longest, and would have to be measured again without the rejected operations.
  if (!acceptance.all_accepted()) return acceptance;
  std::optional<SurfaceStep> step;
  if (rules.was_within) step = step_between(before, after, affected);
  check.check_deviation(rules.meter.find_far({.tracked = after.tracked(),
                                              .mesh = after.mesh(),
                                              .bound = rules.max_deviation,
                                              .walls = rules.walls,
                                              .lost = rules.lost,
                                              .step = step ? &*step : nullptr}));
  return acceptance;
}

}  // namespace meshalyzer
