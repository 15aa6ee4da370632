#include "meshalyzer/analysis/internal/complex_topology.h"

#include "meshalyzer/analysis/internal/edge_lists.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/boundary.h"
#include "meshalyzer/topology/duplicate_faces.h"
#include "meshalyzer/topology/edges.h"
#include "meshalyzer/topology/manifold.h"
#include "meshalyzer/topology/orientation.h"

#include <span>

namespace meshalyzer {
namespace {

void count_components(const PreparedMesh& mesh, std::span<const HalfedgeHandle> border_edges,
                      ComplexTopology& topology) {
  const CutMesh& cut = mesh.cut();
  // Where no vertex was copied, all faces at a vertex are joined through edges.
  const Components edge_components =
      cut.side.copies.empty() ? mesh.components() : find_edge_components(cut);
  const Orientability orientability = find_orientability(cut, edge_components);
  const BoundaryLoops boundaries = find_boundary_loops(cut, border_edges);
  topology.counts = count_by_component(cut, {.components = mesh.components(),
                                             .edge_components = edge_components,
                                             .orientability = orientability,
                                             .boundaries = boundaries});
  topology.n_edges = n_edges(cut);
  topology.n_edge_components = edge_components.count;
  topology.n_boundaries = boundaries.size();
  topology.orientable = orientability.orientable;
}

void list_edges_and_vertices(const CutMesh& cut, std::span<const HalfedgeHandle> border_edges,
                             Offenders& offenders) {
  offenders.border_edges = list_edges(cut, border_edges);
  offenders.non_manifold_edges = list_cut_edges(cut, cut.side.non_manifold_edges);
  offenders.flipped_edges = list_cut_edges(cut, cut.side.flipped_edges);
  offenders.non_manifold_vertices = cut.side.non_manifold_vertices;
  offenders.pinched_vertices = find_pinched_vertices(cut);
}

void list_duplicates(const CutMesh& cut, Offenders& offenders) {
  for (const FaceHandle f : find_duplicate_faces(cut)) {
    offenders.duplicate_faces.push_back(cut.side.face(f));
  }
}

}  // namespace

ComplexTopology analyze_topology(const PreparedMesh& mesh, Offenders& offenders) {
  const CutMesh& cut = mesh.cut();
  const std::vector<HalfedgeHandle> border_edges = find_border_edges(cut);
  ComplexTopology topology;
  parallel_invoke(cut.mesh.n_faces(), {[&] { count_components(mesh, border_edges, topology); },
                                       [&] {
                                         list_edges_and_vertices(cut, border_edges, offenders);
                                         list_duplicates(cut, offenders);
                                       }});
  return topology;
}

}  // namespace meshalyzer
