#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/topology/boundary.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <array>
#include <vector>

namespace meshalyzer {
namespace {

using Edge = std::array<Index, 2>;

std::vector<Edge> edges_of(const CutMesh& cut, const BoundaryLoop& loop) {
  std::vector<Edge> edges;
  edges.reserve(loop.halfedges.size());
  for (const HalfedgeHandle h : loop.halfedges) {
    edges.push_back(ascending_file_ends(cut, h));
  }
  return edges;
}

/// Returns the edges of all slits, sorted.
std::vector<Edge> slit_edges(const DefectList& slits) {
  std::vector<Edge> edges;
  for (const Defect& slit : slits) edges.insert(edges.end(), slit.edges.begin(), slit.edges.end());
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Returns the mean of the midpoints of edges.
Vec3 centre(const Soup& soup, const std::vector<Edge>& edges) {
  Vec3 sum = Vec3::Zero();
  const auto share = 2.0 * static_cast<double>(edges.size());
  for (const auto& [a, b] : edges) {
    // Each term is divided first, so that the sum does not overflow.
    sum += soup.positions[a] / share + soup.positions[b] / share;
  }
  return sum;
}

double length(const Soup& soup, const std::vector<Edge>& edges) {
  double sum = 0.0;
  for (const auto& [a, b] : edges) sum += (soup.positions[b] - soup.positions[a]).stableNorm();
  return sum;
}

}  // namespace

DefectList find_holes(const PreparedMesh& mesh, const DefectList& slits) {
  DefectList defects;
  const BoundaryLoops loops = find_boundary_loops(mesh.cut());
  if (loops.empty()) return defects;
  const std::vector<Edge> slit = slit_edges(slits);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    std::vector<Edge> edges = edges_of(mesh.cut(), loops[i]);
    const bool is_slit = std::all_of(edges.begin(), edges.end(), [&](const Edge& edge) {
      return std::binary_search(slit.begin(), slit.end(), edge);
    });
    if (is_slit) continue;
    Defect defect = make_defect(DefectCode::Hole);
    defect.positions = {centre(mesh.soup(), edges)};
    defect.value = length(mesh.soup(), edges);
    defect.edges = std::move(edges);
    defects.push_back(defect);
  }
  return defects;
}

}  // namespace meshalyzer
