#include "meshalyzer/repair/edits/internal/turned_face.h"

#include "meshalyzer/base/triangle.h"

namespace meshalyzer {

bool normals_agree(const Soup& soup, Index face) {
  if (soup.corner_normals.empty() || !has_all_corners(soup.triangles[face])) return false;
  const Vec3 normal = angle_weighted_normal(corners_of(soup, face), 0);
  int n_more = 0;
  for (const Index given : soup.corner_normals[face]) {
    if (given == kNoIndex) continue;
    n_more += soup.normals[given].dot(normal) > 0.0 ? 1 : -1;
  }
  return n_more > 0;
}

Edits::ChangedFace turned_face(const Soup& soup, Index op, Index face) {
  const auto& [a, b, c] = soup.triangles[face];
  return {.op = op, .face = face, .corners = {a, c, b}, .turns_normals = normals_agree(soup, face)};
}

}  // namespace meshalyzer
