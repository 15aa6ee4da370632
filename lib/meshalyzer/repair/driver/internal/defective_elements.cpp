#include "meshalyzer/repair/driver/internal/defective_elements.h"

#include "meshalyzer/defects/finders.h"
#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/duplicate_faces.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>

namespace meshalyzer {
namespace {

class Collector {
 public:
  explicit Collector(const TrackedMesh& tracked, const CutMesh& cut)
      : tracked_(tracked), cut_(cut) {}

  void add_face(DefectCode code, Index face) {
    defective_elements_.push_back(
        {code, DefectiveElement::Element::Face, {tracked_.face_keys[face], kNoIndex}});
  }
  void add_vertex(DefectCode code, Index vertex) {
    defective_elements_.push_back(
        {code, DefectiveElement::Element::Vertex, {tracked_.vertex_keys[vertex], kNoIndex}});
  }
  void add_edge(DefectCode code, HalfedgeHandle halfedge) {
    const std::array<Index, 2> ends = file_ends(cut_, halfedge);
    const Index a = tracked_.vertex_keys[ends[0]];
    const Index b = tracked_.vertex_keys[ends[1]];
    defective_elements_.push_back(
        {code, DefectiveElement::Element::Edge, {std::min(a, b), std::max(a, b)}});
  }
  [[nodiscard]] std::vector<DefectiveElement> take() {
    std::sort(defective_elements_.begin(), defective_elements_.end());
    return std::move(defective_elements_);
  }

 private:
  const TrackedMesh& tracked_;
  const CutMesh& cut_;
  std::vector<DefectiveElement> defective_elements_;
};

}  // namespace

std::vector<DefectiveElement> find_defective_elements(const TrackedMesh& tracked,
                                                      const PreparedMesh& mesh,
                                                      const Tolerances& tolerances) {
  const CutMesh& cut = mesh.cut();
  Collector defective_elements(tracked, cut);
  for (const Defect& defect : find_thin_facets(mesh, tolerances)) {
    defective_elements.add_face(DefectCode::FlatFacet, defect.faces.front());
  }
  for (const HalfedgeHandle h : find_border_edges(cut)) {
    defective_elements.add_edge(DefectCode::Hole, h);
  }
  for (std::size_t i = 0; i < cut.side.non_manifold_edges.size(); ++i) {
    defective_elements.add_edge(DefectCode::NonManifold,
                                cut.side.non_manifold_edges[i].halfedges.front());
  }
  for (const Index v : cut.side.non_manifold_vertices) {
    defective_elements.add_vertex(DefectCode::NonManifold, v);
  }
  for (std::size_t i = 0; i < cut.side.flipped_edges.size(); ++i) {
    defective_elements.add_edge(DefectCode::Flipped, cut.side.flipped_edges[i].halfedges.front());
  }
  for (const FaceHandle f : find_duplicate_faces(cut)) {
    defective_elements.add_face(DefectCode::DuplicateFacet, cut.side.face(f));
  }
  return defective_elements.take();
}

}  // namespace meshalyzer
