#include "meshalyzer/repair/driver/internal/covered_segments.h"

#include "meshalyzer/arrangement/face_simplex.h"
#include "meshalyzer/mesh/edge_key.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace meshalyzer {
namespace {

/// A face of zero area.
struct CollinearFace {
  Index face = kNoIndex;
  /// The edge that is as long as the face, and its ends.
  std::uint64_t edge = 0;
  VertexPair ends{};
};

/// The faces of zero area that are as long as one edge, and what stands for them.
struct CoveredEdge {
  std::uint64_t edge = 0;
  VertexPair ends{};
  /// Whether a face has the edge that is a triangle, or longer.
  bool is_of_larger_face = false;
  /// The lowest of the faces that are as long as the edge: it stands for the others.
  Index lowest = kNoIndex;

  [[nodiscard]] bool stands_for(Index face) const { return is_of_larger_face || lowest < face; }
};

std::vector<CollinearFace> find_collinear_faces(const Soup& soup,
                                                const std::vector<ChangedFace>& faces) {
  std::vector<CollinearFace> found;
  for (const ChangedFace& changed : faces) {
    const FaceSimplex simplex = face_simplex(soup, changed.face);
    if (simplex.dimension != 1) continue;
    found.push_back({changed.face, edge_key(simplex.ends[0], simplex.ends[1]), simplex.ends});
  }
  return found;
}

/// Returns the edges of faces of zero area, each once, ascending.
std::vector<CoveredEdge> edges_of(const std::vector<CollinearFace>& faces) {
  std::vector<CoveredEdge> edges;
  for (const CollinearFace& each : faces) edges.push_back({each.edge, each.ends});
  std::sort(edges.begin(), edges.end(),
            [](const CoveredEdge& a, const CoveredEdge& b) { return a.edge < b.edge; });
  const auto is_same = [](const CoveredEdge& a, const CoveredEdge& b) { return a.edge == b.edge; };
  edges.erase(std::unique(edges.begin(), edges.end(), is_same), edges.end());
  return edges;
}

/// Returns an edge, nullptr where it is none of them.
CoveredEdge* find_edge(std::vector<CoveredEdge>& edges, std::uint64_t edge) {
  const auto at =
      std::lower_bound(edges.begin(), edges.end(), edge,
                       [](const CoveredEdge& each, std::uint64_t e) { return each.edge < e; });
  return at != edges.end() && at->edge == edge ? &*at : nullptr;
}

/// Notes that a face has an edge. Other vertices at the same positions make the same segment.
void note_face(const Soup& soup, const FaceSimplex& face, CoveredEdge& edge) {
  const auto is_same_end = [&](std::size_t end) {
    return soup.positions[face.ends[end]] == soup.positions[edge.ends[end]];
  };
  if (face.is_triangle() || !is_same_end(0) || !is_same_end(1)) {
    edge.is_of_larger_face = true;
  } else {
    edge.lowest = std::min(edge.lowest, face.face);
  }
}

}  // namespace

void drop_covered_segments(const Soup& soup, std::vector<ChangedFace>& faces) {
  const std::vector<CollinearFace> collinear = find_collinear_faces(soup, faces);
  if (collinear.empty()) return;
  std::vector<CoveredEdge> edges = edges_of(collinear);
  for (const ChangedFace& changed : faces) {
    const Triangle& t = soup.triangles[changed.face];
    for (std::size_t i = 0; i < 3; ++i) {
      CoveredEdge* const edge = find_edge(edges, edge_key(t[i], t[(i + 1) % 3]));
      if (edge != nullptr) note_face(soup, face_simplex(soup, changed.face), *edge);
    }
  }
  std::vector<Index> covered;
  for (const CollinearFace& each : collinear) {
    if (find_edge(edges, each.edge)->stands_for(each.face)) covered.push_back(each.face);
  }
  std::sort(covered.begin(), covered.end());
  std::erase_if(faces, [&](const ChangedFace& changed) {
    return std::binary_search(covered.begin(), covered.end(), changed.face);
  });
}

}  // namespace meshalyzer
