#include "meshalyzer/topology/manifold.h"

#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <iterator>

namespace meshalyzer {

std::vector<Index> find_pinched_vertices(const CutMesh& cut) {
  const CutEdges& edges = cut.side.non_manifold_edges;
  std::vector<Index> on_edges;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto ends = file_ends(cut, edges[i].halfedges[0]);
    on_edges.insert(on_edges.end(), ends.begin(), ends.end());
  }
  // A vertex at which several edges end occurs several times; std::set_difference allows that.
  std::sort(on_edges.begin(), on_edges.end());
  const std::vector<Index>& vertices = cut.side.non_manifold_vertices;
  std::vector<Index> pinched;
  std::set_difference(vertices.begin(), vertices.end(), on_edges.begin(), on_edges.end(),
                      std::back_inserter(pinched));
  return pinched;
}

}  // namespace meshalyzer
