#pragma once

#include "meshalyzer/repair/edits/tracked_mesh.h"
#include "support/shapes.h"

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace meshalyzer {

// Tracked meshes for the tests of the driver.

using Faces = std::vector<Index>;

inline TrackedMesh without_faces(TrackedMesh tracked, const Faces& faces) {
  tracked.soup = shapes::without_faces(tracked.soup, faces);
  for (auto face = faces.rbegin(); face != faces.rend(); ++face) {
    tracked.face_keys.erase(tracked.face_keys.begin() + static_cast<std::ptrdiff_t>(*face));
  }
  return tracked;
}

/// @param origin  kNoIndex: it is part of a hole patch.
inline void add_face(TrackedMesh& tracked, const Triangle& corners, Index origin) {
  tracked.face_keys.push_back(static_cast<Index>(tracked.n_face_keys()));
  tracked.face_origins.push_back(origin);
  tracked.soup.triangles.push_back(corners);
}

inline Faces face_range(Index begin, Index end) {
  Faces faces(end - begin);
  std::iota(faces.begin(), faces.end(), begin);
  return faces;
}

}  // namespace meshalyzer
