#include "meshalyzer/repair/driver/internal/repair_state.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/repair/driver/internal/pairs_of_faces.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns, by face key, where the face stands in the soup.
std::vector<Index> places_of_keys(const TrackedMesh& tracked) {
  std::vector<Index> place(tracked.n_face_keys(), kNoIndex);
  for (std::size_t f = 0; f < tracked.face_keys.size(); ++f) {
    place[tracked.face_keys[f]] = static_cast<Index>(f);
  }
  return place;
}

/// A corner of a face, by the key of its vertex.
struct KeyedCorner {
  Index key = kNoIndex;
  Vec3 position = Vec3::Zero();

  friend bool operator==(const KeyedCorner& a, const KeyedCorner& b) {
    return a.key == b.key && a.position == b.position;
  }
};

std::array<KeyedCorner, 3> keyed_corners(const TrackedMesh& tracked, Index face) {
  std::array<KeyedCorner, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const Index v = tracked.soup.triangles[face][i];
    if (v != kNoIndex) corners[i] = {tracked.vertex_keys[v], tracked.soup.positions[v]};
  }
  return corners;
}

/// The faces of a state whose pairs are known that are the same in another mesh.
struct SameFaces {
  const RepairState* known = nullptr;
  /// #faces of the known state: the place of each in the other mesh; kNoIndex for those that are
  /// not the same there.
  std::vector<Index> place;
  std::size_t count = 0;
};

/// Finds the faces that have the same vertices at the same positions, in any order: two such faces
/// meet each other as before.
///
/// @param affected  By the change that has made `tracked` from the mesh that the known state is, or
///                  was made from.
SameFaces find_same_faces(const RepairState& known, const AffectedElements& affected,
                          const TrackedMesh& tracked, const std::vector<Index>& place_of_key) {
  SameFaces same{&known, std::vector<Index>(known.tracked().soup.n_faces(), kNoIndex), 0};
  std::vector<std::uint8_t> is_doubtful(known.tracked().n_face_keys(), 0);
  for (const Index key : known.affected_faces()) is_doubtful[key] = 1;
  for (const AffectedElement& entry : affected.faces_before) is_doubtful[entry.key] = 1;
  for (Index face = 0; face < same.place.size(); ++face) {
    const Index key = known.tracked().face_keys[face];
    const Index place = key < place_of_key.size() ? place_of_key[key] : kNoIndex;
    if (place == kNoIndex) continue;
    if (is_doubtful[key] != 0) {
      const auto corners = keyed_corners(known.tracked(), face);
      const auto others = keyed_corners(tracked, place);
      if (!std::is_permutation(corners.begin(), corners.end(), others.begin())) continue;
    }
    same.place[face] = place;
    ++same.count;
  }
  return same;
}

/// Returns the pairs of faces that are the same in the other mesh.
std::vector<IntersectingPair> pairs_of_same_faces(const SameFaces& same) {
  std::vector<IntersectingPair> kept;
  for (IntersectingPair pair : same.known->mesh().intersecting_pairs()) {
    const Index a = same.place[pair.face_a];
    const Index b = same.place[pair.face_b];
    if (a == kNoIndex || b == kNoIndex) continue;
    pair.face_a = std::min(a, b);
    pair.face_b = std::max(a, b);
    kept.push_back(pair);
  }
  return kept;
}

/// Returns the faces that the known state has not, ascending.
std::vector<Index> other_faces(const SameFaces& same, std::size_t n_faces) {
  std::vector<std::uint8_t> is_same(n_faces, 0);
  for (const Index face : same.place) {
    if (face != kNoIndex) is_same[face] = 1;
  }
  std::vector<Index> others;
  for (Index face = 0; face < n_faces; ++face) {
    if (is_same[face] == 0) others.push_back(face);
  }
  return others;
}

/// Returns the pairs with a face that is affected.
std::vector<IntersectingPair> pairs_with(const std::vector<IntersectingPair>& pairs,
                                         const std::vector<Index>& affected_keys,
                                         const std::vector<Index>& place_of_key,
                                         std::size_t n_faces) {
  std::vector<std::uint8_t> is_affected(n_faces, 0);
  for (const Index key : affected_keys) {
    // A face that is moved by one operation and removed by another has no place.
    if (place_of_key[key] != kNoIndex) is_affected[place_of_key[key]] = 1;
  }
  std::vector<IntersectingPair> found;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(found),
               [&](const IntersectingPair& pair) {
                 return is_affected[pair.face_a] != 0 || is_affected[pair.face_b] != 0;
               });
  return found;
}

std::vector<Index> keys_of(const std::vector<AffectedElement>& entries) {
  std::vector<Index> keys;
  for (const AffectedElement& entry : entries) keys.push_back(entry.key);
  sort_unique(keys);
  return keys;
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
                         const KnownStates& known, const AffectedElements& affected)
    : tracked_(std::move(tracked)),
      mesh_(tracked_.soup),
      defective_elements_(find_defective_elements(tracked_, mesh_, tolerances)),
      affected_faces_(keys_of(affected.faces_after)) {
  const std::vector<Index> place = places_of_keys(tracked_);
  SameFaces same = find_same_faces(known.before, affected, tracked_, place);
  if (known.trial != nullptr) {
    SameFaces as_tried = find_same_faces(*known.trial, affected, tracked_, place);
    if (as_tried.count > same.count) same = std::move(as_tried);
  }
  const std::size_t n_faces = tracked_.soup.n_faces();
  std::vector<IntersectingPair> pairs =
      joined_pairs(find_pairs_of(mesh_, other_faces(same, n_faces)), pairs_of_same_faces(same));
  affected_pairs_ = pairs_with(pairs, affected_faces_, place, n_faces);
  mesh_.set_intersecting_pairs(std::move(pairs));
}

}  // namespace meshalyzer
