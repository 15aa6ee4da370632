#include "meshalyzer/repair/split/internal/incident_faces.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/runs.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

/// Appends the faces at a mesh vertex.
void append_faces(const CutMesh& cut, VertexHandle v, std::vector<Index>& faces) {
  if (cut.mesh.is_isolated(v)) return;
  for (const FaceHandle f : cut.mesh.vf_range(v)) faces.push_back(cut.side.face(f));
}

/// Joins the faces at an edge that ends at the vertex.
void join_edge(std::span<const Spoke> edge, const JoinWideEdge& join, DisjointSets& fans) {
  if (edge.size() == 2) {
    fans.unite(edge[0].place, edge[1].place);
  } else if (edge.size() > 2) {
    const std::vector<Index> partner = join(edge);
    for (std::size_t i = 0; i < edge.size(); ++i) {
      if (partner[i] != kNoIndex) fans.unite(edge[i].place, edge[partner[i]].place);
    }
  }
}

}  // namespace

IncidentFaces::IncidentFaces(const CutMesh& cut, std::vector<Index> vertices)
    : vertices_(std::move(vertices)) {
  for (const Index v : vertices_) {
    for (const VertexHandle copy : cut.side.mesh_vertices(v)) append_faces(cut, copy, faces_);
    std::sort(faces_.begin() + static_cast<std::ptrdiff_t>(begin_.back()), faces_.end());
    begin_.push_back(faces_.size());
  }
}

std::size_t IncidentFaces::entry_of(Index vertex) const {
  return static_cast<std::size_t>(std::lower_bound(vertices_.begin(), vertices_.end(), vertex) -
                                  vertices_.begin());
}

std::size_t IncidentFaces::place(std::size_t entry, Index face) const {
  const auto all = faces(entry);
  return static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), face) - all.begin());
}

std::vector<Spoke> find_spokes(const Soup& soup, const IncidentFaces& incident, std::size_t entry) {
  std::vector<Spoke> spokes;
  const auto faces = incident.faces(entry);
  for (Index place = 0; place < faces.size(); ++place) {
    for (const Index v : soup.triangles[faces[place]]) {
      if (v != incident.vertex(entry)) spokes.push_back({.other = v, .place = place});
    }
  }
  std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) {
    return std::tie(a.other, a.place) < std::tie(b.other, b.place);
  });
  return spokes;
}

std::vector<Index> find_fans_at(const Soup& soup, const IncidentFaces& incident, std::size_t entry,
                                const JoinWideEdge& join) {
  const std::vector<Spoke> spokes = find_spokes(soup, incident, entry);
  DisjointSets joined(incident.faces(entry).size());
  for_each_run(std::span(spokes), &Spoke::other,
               [&](std::span<const Spoke> edge) { join_edge(edge, join, joined); });
  return joined.number_all().of;
}

}  // namespace meshalyzer
