#include "meshalyzer/repair/driver/internal/covered_segments.h"

#include "meshalyzer/arrangement/face_simplex.h"
#include "meshalyzer/base/corners.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/mesh/edge_key.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace meshalyzer {
namespace {

/// A face of zero area.
struct CollinearFace {
  /// The edge that is as long as the face.
  std::uint64_t edge = 0;
  FaceSimplex simplex;
};

/// Returns the faces that are segments, by their edges.
std::vector<CollinearFace> find_collinear_faces(const Soup& soup,
                                                const std::vector<ChangedFace>& faces) {
  std::vector<CollinearFace> segments;
  for (const ChangedFace& changed : faces) {
    const Corners t = corners_of(soup, changed.face);
    if (!are_collinear(t[0], t[1], t[2])) continue;
    const FaceSimplex simplex = face_simplex(soup, changed.face);
    if (simplex.dimension != 1) continue;
    segments.push_back({edge_key(simplex.ends[0], simplex.ends[1]), simplex});
  }
  std::sort(segments.begin(), segments.end(),
            [](const CollinearFace& a, const CollinearFace& b) { return a.edge < b.edge; });
  return segments;
}

/// Tells whether a face that has the edge of a segment stands for it. Of equal segments the one
/// with the lowest number does, so that no two stand for each other.
bool stands_for(const Soup& soup, const FaceSimplex& face, const FaceSimplex& segment) {
  if (face.face == segment.face) return false;
  const auto have_same_end = [&](std::size_t end) {
    return soup.positions[face.ends[end]] == soup.positions[segment.ends[end]];
  };
  const bool are_equal = !face.is_triangle() && have_same_end(0) && have_same_end(1);
  return !are_equal || face.face < segment.face;
}

}  // namespace

void drop_covered_segments(const Soup& soup, std::vector<ChangedFace>& faces) {
  const std::vector<CollinearFace> segments = find_collinear_faces(soup, faces);
  if (segments.empty()) return;
  std::vector<Index> covered;
  for (const ChangedFace& changed : faces) {
    const Triangle& t = soup.triangles[changed.face];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t edge = edge_key(t[i], t[(i + 1) % 3]);
      auto at = std::lower_bound(
          segments.begin(), segments.end(), edge,
          [](const CollinearFace& segment, std::uint64_t e) { return segment.edge < e; });
      if (at == segments.end() || at->edge != edge) continue;
      const FaceSimplex face = face_simplex(soup, changed.face);
      for (; at != segments.end() && at->edge == edge; ++at) {
        if (stands_for(soup, face, at->simplex)) covered.push_back(at->simplex.face);
      }
    }
  }
  std::sort(covered.begin(), covered.end());
  std::erase_if(faces, [&](const ChangedFace& changed) {
    return std::binary_search(covered.begin(), covered.end(), changed.face);
  });
}

}  // namespace meshalyzer
