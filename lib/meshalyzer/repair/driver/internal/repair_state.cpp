#include "meshalyzer/repair/driver/internal/repair_state.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/repair/driver/internal/pairs_of_faces.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns, by face key, where the face stands in the soup.
std::vector<Index> places_of_keys(const TrackedMesh& tracked) {
  std::vector<Index> place(tracked.n_input_faces + tracked.face_origins.size(), kNoIndex);
  for (std::size_t f = 0; f < tracked.face_keys.size(); ++f) {
    place[tracked.face_keys[f]] = static_cast<Index>(f);
  }
  return place;
}

/// Returns the pairs of faces that a change did not affect.
std::vector<IntersectingPair> unaffected_pairs(const RepairState& before,
                                               const AffectedElements& affected,
                                               const std::vector<Index>& place) {
  std::vector<IntersectingPair> kept;
  const std::vector<Index>& keys = before.tracked().face_keys;
  std::vector<std::uint8_t> is_affected(place.size(), 0);
  for (const AffectedElement& entry : affected.faces_before) is_affected[entry.key] = 1;
  for (IntersectingPair pair : before.mesh().intersecting_pairs()) {
    const Index a = keys[pair.face_a];
    const Index b = keys[pair.face_b];
    if (is_affected[a] != 0 || is_affected[b] != 0) continue;
    pair.face_a = std::min(place[a], place[b]);
    pair.face_b = std::max(place[a], place[b]);
    kept.push_back(pair);
  }
  return kept;
}

std::vector<Index> affected_faces(const AffectedElements& affected,
                                  const std::vector<Index>& place) {
  std::vector<Index> faces;
  for (const AffectedElement& entry : affected.faces_after) {
    // A face that is moved by one operation and removed by another has no place.
    if (place[entry.key] != kNoIndex) faces.push_back(place[entry.key]);
  }
  sort_unique(faces);
  return faces;
}

}  // namespace

RepairState::RepairState(TrackedMesh tracked, const Tolerances& tolerances, PairLimits limits)
    : tracked_(std::move(tracked)),
      mesh_(tracked_.soup, std::move(limits)),
      defective_elements_(find_defective_elements(tracked_, mesh_, tolerances)) {}

RepairState::RepairState(TrackedMesh tracked, const Tolerances& tolerances,
                         std::vector<IntersectingPair> pairs)
    : RepairState(std::move(tracked), tolerances) {
  mesh_.set_intersecting_pairs(std::move(pairs));
}

RepairState::RepairState(TrackedMesh tracked, const Tolerances& tolerances,
                         const RepairState& before, const AffectedElements& affected)
    : tracked_(std::move(tracked)),
      mesh_(tracked_.soup),
      defective_elements_(find_defective_elements(tracked_, mesh_, tolerances)) {
  const std::vector<Index> place = places_of_keys(tracked_);
  affected_pairs_ = find_pairs_of(mesh_, affected_faces(affected, place));
  mesh_.set_intersecting_pairs(
      joined_pairs(unaffected_pairs(before, affected, place), affected_pairs_));
}

}  // namespace meshalyzer
