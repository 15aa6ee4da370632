#include "meshalyzer/spatial/faces_meeting_box.h"

#include "meshalyzer/spatial/visit_meeting.h"

#include <cstddef>

namespace meshalyzer {

std::vector<Index> find_faces_meeting(const FaceTree& tree, const Box3& box) {
  // Boxes of the tree are within -1 ... 1 except for rounding. Points far outside are brought
  // nearer, because empty boxes are at infinity.
  constexpr float kNearby = 4.0F;
  std::vector<Index> faces;
  const TreeBox wanted{tree.map_within(box.min(), kNearby), tree.map_within(box.max(), kNearby)};
  visit_meeting(tree, wanted, [&](std::size_t slot) {
    faces.push_back(tree.mesh_face(slot));
    return true;
  });
  return faces;
}

}  // namespace meshalyzer
