#include "meshalyzer/repair/trial/flaws.h"

#include "meshalyzer/defects/finders.h"
#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/duplicate_faces.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>

namespace meshalyzer {
namespace {

class Collector {
 public:
  explicit Collector(const Draft& draft, const CutMesh& cut) : draft_(draft), cut_(cut) {}

  void add_face(DefectCode code, Index face) {
    flaws_.push_back({code, Flaw::Element::Face, {draft_.face_keys[face], kNoIndex}});
  }
  void add_vertex(DefectCode code, Index vertex) {
    flaws_.push_back({code, Flaw::Element::Vertex, {draft_.vertex_keys[vertex], kNoIndex}});
  }
  void add_edge(DefectCode code, HalfedgeHandle halfedge) {
    const std::array<Index, 2> ends = file_ends(cut_, halfedge);
    const Index a = draft_.vertex_keys[ends[0]];
    const Index b = draft_.vertex_keys[ends[1]];
    flaws_.push_back({code, Flaw::Element::Edge, {std::min(a, b), std::max(a, b)}});
  }
  [[nodiscard]] std::vector<Flaw> take() {
    std::sort(flaws_.begin(), flaws_.end());
    return std::move(flaws_);
  }

 private:
  const Draft& draft_;
  const CutMesh& cut_;
  std::vector<Flaw> flaws_;
};

}  // namespace

std::vector<Flaw> find_flaws(const Draft& draft, const PreparedMesh& mesh,
                             const Tolerances& tolerances) {
  const CutMesh& cut = mesh.cut();
  Collector flaws(draft, cut);
  for (const Defect& defect : find_thin_facets(mesh, tolerances)) {
    flaws.add_face(DefectCode::FlatFacet, defect.faces.front());
  }
  for (const HalfedgeHandle h : find_border_edges(cut)) flaws.add_edge(DefectCode::Hole, h);
  for (std::size_t i = 0; i < cut.side.non_manifold_edges.size(); ++i) {
    flaws.add_edge(DefectCode::NonManifold, cut.side.non_manifold_edges[i].halfedges.front());
  }
  for (const Index v : cut.side.non_manifold_vertices) {
    flaws.add_vertex(DefectCode::NonManifold, v);
  }
  for (std::size_t i = 0; i < cut.side.flipped_edges.size(); ++i) {
    flaws.add_edge(DefectCode::Flipped, cut.side.flipped_edges[i].halfedges.front());
  }
  for (const FaceHandle f : find_duplicate_faces(cut)) {
    flaws.add_face(DefectCode::DuplicateFacet, cut.side.face(f));
  }
  return flaws.take();
}

}  // namespace meshalyzer
