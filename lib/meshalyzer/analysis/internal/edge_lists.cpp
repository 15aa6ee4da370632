#include "meshalyzer/analysis/internal/edge_lists.h"

#include "meshalyzer/mesh/inner_halfedge.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <numeric>

namespace meshalyzer {
namespace {

using Ends = std::array<Index, 2>;

Index file_face(const CutMesh& cut, HalfedgeHandle h) {
  return cut.side.face(cut.mesh.face_handle(h));
}

/// Returns the half-edges of the cut edge between two file vertices; empty if the list has no such
/// edge.
std::span<const HalfedgeHandle> find_cut_edge(const CutMesh& cut, const CutEdges& edges,
                                              const Ends& ends) {
  std::size_t low = 0;
  std::size_t high = edges.size();
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (ascending_file_ends(cut, edges[middle].halfedges.front()) < ends) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  const bool found =
      low < edges.size() && ascending_file_ends(cut, edges[low].halfedges.front()) == ends;
  return found ? edges[low].halfedges : std::span<const HalfedgeHandle>();
}

/// Appends all faces of the complex at an edge, ascending.
void append_faces_at(const CutMesh& cut, HalfedgeHandle h, std::vector<Index>& faces) {
  const auto n_before = static_cast<std::ptrdiff_t>(faces.size());
  const HalfedgeHandle opposite = cut.mesh.opposite_halfedge_handle(h);
  if (!cut.mesh.is_boundary(h) && !cut.mesh.is_boundary(opposite)) {
    faces.insert(faces.end(), {file_face(cut, h), file_face(cut, opposite)});
  } else {
    const Ends ends = ascending_file_ends(cut, h);
    for (const CutEdges* edges : {&cut.side.non_manifold_edges, &cut.side.flipped_edges}) {
      for (const HalfedgeHandle each : find_cut_edge(cut, *edges, ends)) {
        faces.push_back(file_face(cut, each));
      }
    }
    if (std::ssize(faces) == n_before) {
      faces.push_back(file_face(cut, inner_halfedge(cut.mesh, h)));
    }
  }
  std::sort(faces.begin() + n_before, faces.end());
}

}  // namespace

EdgeList list_edges(const CutMesh& cut, std::span<const HalfedgeHandle> edges,
                    std::span<const double> values) {
  std::vector<Ends> ends(edges.size());
  std::transform(edges.begin(), edges.end(), ends.begin(),
                 [&](HalfedgeHandle h) { return ascending_file_ends(cut, h); });
  std::vector<Index> order(edges.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return ends[a] < ends[b]; });
  EdgeList list;
  list.ends.reserve(edges.size());
  list.faces.reserve(edges.size());
  list.begin.reserve(edges.size() + 1);
  for (const Index i : order) {
    list.ends.push_back(ends[i]);
    append_faces_at(cut, edges[i], list.faces);
    list.begin.push_back(static_cast<Index>(list.faces.size()));
    if (!values.empty()) {
      list.values.push_back(values[i]);
    }
  }
  return list;
}

EdgeList list_cut_edges(const CutMesh& cut, const CutEdges& edges) {
  EdgeList list;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    list.ends.push_back(ascending_file_ends(cut, edges[i].halfedges.front()));
    for (const HalfedgeHandle h : edges[i].halfedges) {
      list.faces.push_back(file_face(cut, h));
    }
    list.begin.push_back(static_cast<Index>(list.faces.size()));
  }
  return list;
}

EdgeList list_edges_if(const CutMesh& cut, std::span<const HalfedgeHandle> edges,
                       std::span<const double> values,
                       const std::function<bool(double)>& condition) {
  std::vector<HalfedgeHandle> chosen;
  std::vector<double> chosen_values;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (condition(values[i])) {
      chosen.push_back(edges[i]);
      chosen_values.push_back(values[i]);
    }
  }
  return list_edges(cut, chosen, chosen_values);
}

}  // namespace meshalyzer
