#include "meshalyzer/analysis/internal/complex_topology.h"

#include "meshalyzer/analysis/internal/edge_lists.h"
#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/boundary.h"
#include "meshalyzer/topology/duplicate_faces.h"
#include "meshalyzer/topology/edges.h"
#include "meshalyzer/topology/manifold.h"
#include "meshalyzer/topology/orientation.h"

namespace meshalyzer {

ComplexTopology analyze_topology(const PreparedMesh& mesh, Offenders& offenders) {
  const CutMesh& cut = mesh.cut();
  ComplexTopology topology;
  const Components edge_components = find_edge_components(cut);
  const Orientability orientability = find_orientability(cut, edge_components);
  const std::vector<BoundaryLoop> boundaries = find_boundary_loops(cut);
  topology.counts = count_by_component(cut, {.components = mesh.components(),
                                             .edge_components = edge_components,
                                             .orientability = orientability,
                                             .boundaries = boundaries});
  topology.n_edges = n_edges(cut);
  topology.n_edge_components = edge_components.count;
  topology.n_boundaries = boundaries.size();
  topology.orientable = orientability.orientable;

  offenders.border_edges = list_edges(cut, find_border_edges(cut));
  offenders.non_manifold_edges = list_cut_edges(cut, cut.side.non_manifold_edges);
  offenders.flipped_edges = list_cut_edges(cut, cut.side.flipped_edges);
  offenders.non_manifold_vertices = cut.side.non_manifold_vertices;
  offenders.pinched_vertices = find_pinched_vertices(cut);
  for (const FaceHandle f : find_duplicate_faces(cut)) {
    offenders.duplicate_faces.push_back(cut.side.face(f));
  }
  return topology;
}

}  // namespace meshalyzer
