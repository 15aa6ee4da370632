#include "meshalyzer/repair/trial/repair_state.h"

#include "meshalyzer/spatial/self_intersection_of.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace meshalyzer {
namespace {

bool comes_before(const IntersectingPair& p, const IntersectingPair& q) {
  return std::pair(p.face_a, p.face_b) < std::pair(q.face_a, q.face_b);
}

/// By face key: where the face stands in the soup.
std::vector<Index> places_of_keys(const Draft& draft) {
  std::vector<Index> place(draft.n_input_faces + draft.face_origins.size(), kNoIndex);
  for (std::size_t f = 0; f < draft.face_keys.size(); ++f) {
    place[draft.face_keys[f]] = static_cast<Index>(f);
  }
  return place;
}

/// The pairs of faces that a change did not touch: both are what they were.
std::vector<IntersectingPair> untouched_pairs(const RepairState& before, const Touched& touched,
                                              const std::vector<Index>& place) {
  std::vector<IntersectingPair> kept;
  const std::vector<Index>& keys = before.draft().face_keys;
  for (IntersectingPair pair : before.mesh().intersecting_pairs()) {
    const Index a = keys[pair.face_a];
    const Index b = keys[pair.face_b];
    if (!touching(touched.faces_before, a).empty() || !touching(touched.faces_before, b).empty()) {
      continue;
    }
    pair.face_a = std::min(place[a], place[b]);
    pair.face_b = std::max(place[a], place[b]);
    kept.push_back(pair);
  }
  return kept;
}

std::vector<Index> touched_faces(const Touched& touched, const std::vector<Index>& place) {
  std::vector<Index> faces;
  for (const Touch& touch : touched.faces_after) {
    // A face that is moved by one operation and removed by another has no place.
    if (place[touch.key] != kNoIndex) faces.push_back(place[touch.key]);
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace

RepairState::RepairState(Draft draft, const Tolerances& tolerances)
    : draft_(std::move(draft)), mesh_(draft_.soup), flaws_(find_flaws(draft_, mesh_, tolerances)) {}

RepairState::RepairState(Draft draft, const Tolerances& tolerances, const RepairState& before,
                         const Touched& touched)
    : draft_(std::move(draft)), mesh_(draft_.soup), flaws_(find_flaws(draft_, mesh_, tolerances)) {
  const std::vector<Index> place = places_of_keys(draft_);
  touched_pairs_ =
      find_self_intersections_of(mesh_.cut(), mesh_.tree(), touched_faces(touched, place));
  std::vector<IntersectingPair> pairs = untouched_pairs(before, touched, place);
  pairs.insert(pairs.end(), touched_pairs_.begin(), touched_pairs_.end());
  std::sort(pairs.begin(), pairs.end(), comes_before);
  mesh_.set_intersecting_pairs(std::move(pairs));
}

}  // namespace meshalyzer
