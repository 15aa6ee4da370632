#include "meshalyzer/repair/fix_face_defects.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns the faces of a group, by index in a soup.
std::vector<Index> faces_of(const Soup& soup, std::size_t group) {
  const std::vector<Group>& groups = soup.groups;
  const auto end =
      group + 1 < groups.size() ? groups[group + 1].first_face : static_cast<Index>(soup.n_faces());
  std::vector<Index> faces;
  for (Index f = groups[group].first_face; f < end; ++f) faces.push_back(f);
  return faces;
}

/// Tells whether a face of the result is unchanged, with corners at the same positions.
bool is_same_face(const Soup& input, const TrackedMesh& tracked, Index before, Index after) {
  if (tracked.face_keys[after] != before) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Index was = input.triangles[before][k];
    const Index is = tracked.soup.triangles[after][k];
    if (was == kNoIndex || is == kNoIndex) {
      if (was != is) return false;
    } else if (tracked.vertex_keys[is] != was ||
               input.positions[was] != tracked.soup.positions[is]) {
      return false;
    }
  }
  return true;
}

bool is_edited(const Soup& input, const TrackedMesh& tracked, const FaceTracking& face) {
  return !std::equal(
      face.before.begin(), face.before.end(), face.after.begin(), face.after.end(),
      [&](Index before, Index after) { return is_same_face(input, tracked, before, after); });
}

}  // namespace

FaceRepairResult fix_face_defects(Soup soup, RepairOptions options) {
  options.groups = Groups::Faces;
  options.fixes.erase(DefectCode::Disjoint);
  const Soup input = soup;
  FaceRepairResult result;
  result.repair = fix_defects(std::move(soup), options);
  const TrackedMesh& tracked = result.repair.meshes.front().tracked;
  for (std::size_t g = 0; g < input.groups.size(); ++g) {
    FaceTracking face{input.groups[g].name, faces_of(input, g), faces_of(tracked.soup, g)};
    if (is_edited(input, tracked, face)) result.edited.push_back(std::move(face));
  }
  return result;
}

}  // namespace meshalyzer
