#include "meshalyzer/repair/trial/judge_trial.h"

#include "meshalyzer/repair/trial/known_contacts.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>

namespace meshalyzer {
namespace {

Box3 box_of(const Soup& soup, Index face) {
  Box3 box;
  for (const Index v : soup.triangles[face]) {
    if (v != kNoIndex) box.extend(soup.positions[v]);
  }
  return box;
}

std::vector<Flaw> difference(const std::vector<Flaw>& a, const std::vector<Flaw>& b) {
  std::vector<Flaw> result;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

class Judge {
 public:
  Judge(const RepairState& before, const RepairState& after, const Touched& touched,
        const TrialRules& rules, std::vector<Harm>& harms)
      : before_(before), after_(after), touched_(touched), rules_(rules), harms_(harms) {}

  void judge_deviation(const DeviationMeter::Result& deviation) {
    for (const Index face : deviation.far_draft_faces) {
      blame(touching(touched_.faces_after, after_.draft().face_keys[face]), Harm::TooFar);
    }
    for (const Index face : deviation.far_input_faces) {
      if (blame_makers_from(face) || blame_neighbours_of(face)) continue;
      std::fill(harms_.begin(), harms_.end(), Harm::TooFar);
    }
  }

  /// An operation may pass contact on from one of its faces to another, but make none with a face
  /// that it had nothing to do with.
  void judge_pairs() {
    if (after_.touched_pairs().empty()) return;
    const KnownContacts known(before_, touched_);
    const bool may_touch = rules_.may_make.contains(DefectCode::SelfIntersection);
    for (const ContactByKey& pair : contacts_by_key(after_, after_.touched_pairs())) {
      if ((may_touch && pair.kind == ContactKind::Unwelded) || known.have_met(pair)) continue;
      blame_for_contact(pair.face_a, pair.face_b, pair.kind, known);
      blame_for_contact(pair.face_b, pair.face_a, pair.kind, known);
    }
  }

  void judge_flaws() {
    balance_.assign(harms_.size(), {});
    count(difference(after_.flaws(), before_.flaws()), 1);
    count(difference(before_.flaws(), after_.flaws()), -1);
    for (std::size_t op = 0; op < harms_.size(); ++op) {
      for (const DefectCode code : all_defect_codes()) {
        if (balance_[op][static_cast<std::size_t>(code)] > 0 && !rules_.may_make.contains(code)) {
          harms_[op] = Harm::MoreDefects;
        }
      }
    }
  }

 private:
  void blame(std::span<const Touch> touches, Harm harm) {
    for (const Touch& touch : touches) harms_[touch.operation] = harm;
  }

  /// Blames those who work at a face for its contact with another.
  void blame_for_contact(Index face, Index other, ContactKind kind, const KnownContacts& known) {
    for (const Touch& touch : touching(touched_.faces_after, face)) {
      if (!known.has_met(touch.operation, other, kind)) {
        harms_[touch.operation] = Harm::Intersects;
      }
    }
  }

  /// Blames those who now touch what was made of a face of the input.
  bool blame_makers_from(Index input_face) {
    bool is_blamed = false;
    for (const Touch& touch : touched_.faces_before) {
      if (before_.draft().origin_of_key(touch.key) != input_face) continue;
      harms_[touch.operation] = Harm::TooFar;
      is_blamed = true;
    }
    return is_blamed;
  }

  /// Of a face of the input that was gone before: blames those who work where it was.
  bool blame_neighbours_of(Index input_face) {
    Box3 near = box_of(rules_.input, input_face);
    near.min().array() -= rules_.max_deviation;
    near.max().array() += rules_.max_deviation;
    bool is_blamed = false;
    const Draft& draft = before_.draft();
    for (std::size_t f = 0; f < draft.face_keys.size(); ++f) {
      const auto touches = touching(touched_.faces_before, draft.face_keys[f]);
      if (touches.empty() || !near.intersects(box_of(draft.soup, static_cast<Index>(f)))) continue;
      blame(touches, Harm::TooFar);
      is_blamed = true;
    }
    return is_blamed;
  }

  /// Counts flaws for the operations that touch all of their keys.
  void count(const std::vector<Flaw>& flaws, int by) {
    for (const Flaw& flaw : flaws) {
      const auto code = static_cast<std::size_t>(flaw.code);
      if (flaw.element == Flaw::Element::Face) {
        const auto& faces = by > 0 ? touched_.faces_after : touched_.faces_before;
        for (const Touch& touch : touching(faces, flaw.keys[0]))
          balance_[touch.operation][code] += by;
        continue;
      }
      for (const Touch& touch : touching(touched_.vertices, flaw.keys[0])) {
        const Touch other{flaw.keys[1], touch.operation};
        if (flaw.element == Flaw::Element::Vertex ||
            std::binary_search(touched_.vertices.begin(), touched_.vertices.end(), other)) {
          balance_[touch.operation][code] += by;
        }
      }
    }
  }

  const RepairState& before_;
  const RepairState& after_;
  const Touched& touched_;
  const TrialRules& rules_;
  std::vector<Harm>& harms_;
  /// By operation and code: flaws made less flaws taken away.
  std::vector<std::array<int, kDefectCodes>> balance_;
};

}  // namespace

std::string_view harm_reason(Harm harm) {
  switch (harm) {
    case Harm::None:
      return "";
    case Harm::TooFar:
      return "undone: it would move the surface farther than the maximum deviation";
    case Harm::Intersects:
      return "undone: it would make faces intersect";
    case Harm::MoreDefects:
      return "undone: it would make more defects than it mends";
  }
  return "";
}

bool Verdict::is_harmless() const {
  return std::all_of(harms.begin(), harms.end(), [](Harm harm) { return harm == Harm::None; });
}

Verdict judge_trial(const RepairState& before, const RepairState& after, const Touched& touched,
                    std::size_t n_operations, const TrialRules& rules) {
  Verdict verdict;
  verdict.harms.assign(n_operations, Harm::None);
  Judge judge(before, after, touched, rules, verdict.harms);
  judge.judge_flaws();
  judge.judge_pairs();
  const DeviationMeter::Result deviation =
      rules.meter.measure(after.draft(), after.mesh().tree(), rules.max_deviation);
  verdict.deviation = deviation.largest;
  judge.judge_deviation(deviation);
  return verdict;
}

}  // namespace meshalyzer
