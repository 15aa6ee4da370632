#include "meshalyzer/spatial/contact_in_mesh.h"

#include "meshalyzer/spatial/align_faces.h"
#include "meshalyzer/spatial/triangle_contact.h"

namespace meshalyzer {
namespace {

Corners corners_of(const FaceTree& tree, const Triangle& t) {
  return {tree.point(t[0]), tree.point(t[1]), tree.point(t[2])};
}

std::optional<ContactKind> contact_of(const FaceTree& tree, const AlignedFaces<Index>& pair) {
  return find_contact(corners_of(tree, pair.p), corners_of(tree, pair.q),
                      static_cast<Common>(pair.n_common));
}

/// Tells whether no two corners of a face are at one place.
bool has_three_places(const FaceTree& tree, const Triangle& t) {
  const Corners c = corners_of(tree, t);
  return c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
}

/// Tells whether two faces are neighbours along a seam that was never welded: they have a corner in
/// common by place but not by id, and share nothing else when vertices at identical places count as
/// one. This test comes first because it is cheaper than that of the kind of contact.
bool are_unwelded_neighbours(const FaceTree& tree, const AlignedFaces<Index>& by_id,
                             const AlignedFaces<Index>& by_place) {
  return by_place.n_common > by_id.n_common && by_id.n_common < 2 &&
         has_three_places(tree, by_id.p) && has_three_places(tree, by_id.q) &&
         !contact_of(tree, by_place);
}

}  // namespace

std::optional<ContactKind> find_contact_in_mesh(const FaceTree& tree, const Triangle& p,
                                                const Triangle& q) {
  const AlignedFaces<Index> by_id = align_faces(p, q, [](Index a, Index b) { return a == b; });
  const AlignedFaces<Index> by_place = align_faces(
      by_id.p, by_id.q, [&](Index a, Index b) { return tree.point(a) == tree.point(b); });
  if (are_unwelded_neighbours(tree, by_id, by_place)) return ContactKind::Unwelded;
  const std::optional<ContactKind> kind = contact_of(tree, by_id);
  // The contact disappears when vertices at identical places count as one.
  const bool is_unwelded =
      kind && by_place.n_common > by_id.n_common && !contact_of(tree, by_place);
  return is_unwelded ? ContactKind::Unwelded : kind;
}

}  // namespace meshalyzer
