#include "meshalyzer/repair/driver/internal/changed_faces.h"

#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <cstdint>

namespace meshalyzer {
namespace {

bool has_surface(const Soup& soup, Index face) {
  return is_in_complex(soup.triangles[face]);
}

/// Tells for each face of the tracked mesh whether it is the same as the face of the input that it
/// was made of (non-zero).
std::vector<std::uint8_t> find_same(const Soup& input, const TrackedMesh& tracked) {
  std::vector<std::uint8_t> same(tracked.soup.n_faces());
  parallel_chunks(same.size(), [&](Chunk chunk) {
    for (auto face = static_cast<Index>(chunk.begin); face < chunk.end; ++face) {
      const Index origin = tracked.origin_of_face(face);
      same[face] =
          origin != kNoIndex && has_surface(tracked.soup, face) && has_surface(input, origin) &&
                  is_same_surface(corners_of(tracked.soup, face), corners_of(input, origin))
              ? 1
              : 0;
    }
  });
  return same;
}

}  // namespace

bool is_same_surface(const Corners& a, const Corners& b) {
  return a == b || std::is_permutation(a.begin(), a.end(), b.begin(), b.end());
}

ChangedFaces find_changed_faces(const Soup& input, const TrackedMesh& tracked) {
  const std::vector<std::uint8_t> same = find_same(input, tracked);
  ChangedFaces changes;
  // Maps each face of the input to the same face of the tracked mesh, else to one that was made of
  // it.
  std::vector<Index> made_of(input.n_faces(), kNoIndex);
  std::vector<std::uint8_t> is_kept(input.n_faces());
  for (Index face = 0; face < same.size(); ++face) {
    const Index origin = tracked.origin_of_face(face);
    if (origin == kNoIndex || !has_surface(tracked.soup, face)) continue;
    made_of[origin] = face;
    if (same[face] != 0) {
      is_kept[origin] = 1;
    } else {
      changes.of_repaired.push_back({face, has_surface(input, origin) ? origin : kNoIndex});
    }
  }
  for (Index face = 0; face < input.n_faces(); ++face) {
    if (is_kept[face] == 0 && has_surface(input, face)) {
      changes.of_input.push_back({face, made_of[face]});
    }
  }
  return changes;
}

}  // namespace meshalyzer
