#include "meshalyzer/repair/driver/internal/defect_inventory.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/components.h"
#include "meshalyzer/topology/duplicate_faces.h"
#include "meshalyzer/topology/edges.h"
#include "meshalyzer/topology/manifold.h"
#include "meshalyzer/topology/orientation.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {
namespace {

class Inventory {
 public:
  Inventory(const TrackedMesh& tracked, const PreparedMesh& mesh)
      : tracked_(tracked), cut_(mesh.cut()), mesh_(mesh) {}

  void add_topology() {
    using enum CountedDefect;
    for (const HalfedgeHandle h : find_border_edges(cut_)) {
      add_edge(BorderEdges, ends_of(h));
      if (cuts_sheet(ends_of(h))) ++inventory_.n_borders_of_cut_sheets;
    }
    add_cut_edges(NonManifoldEdges, cut_.side.non_manifold_edges);
    add_cut_edges(FlippedEdges, cut_.side.flipped_edges);
    for (const Index v : cut_.side.non_manifold_vertices) add_vertex(NonManifoldVertices, v);
    for (const Index v : find_pinched_vertices(cut_)) add_vertex(PinchedVertices, v);
    for (const FaceHandle f : find_duplicate_faces(cut_)) {
      add_face(DuplicateFaces, cut_.side.face(f));
    }
  }

  void add_slits(const Tolerances& tolerances) {
    for (const Defect& slit : find_slits(mesh_, tolerances)) {
      for (const auto& ends : slit.edges) add_edge(CountedDefect::SlitEdges, ends);
      // The edges on the other side of a cut may have vertices of their own.
      const bool is_of_cut = std::any_of(slit.edges.begin(), slit.edges.end(),
                                         [&](const auto& ends) { return cuts_sheet(ends); });
      if (is_of_cut) inventory_.n_slits_of_cut_sheets += slit.edges.size();
    }
  }

  void add_zero_areas() {
    const Soup& soup = tracked_.soup;
    std::vector<std::uint8_t> is_flat(cut_.side.faces.size());
    parallel_chunks(is_flat.size(), [&](Chunk chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        is_flat[i] = are_collinear(corners_of(soup, cut_.side.faces[i])) ? 1 : 0;
      }
    });
    for (std::size_t i = 0; i < is_flat.size(); ++i) {
      if (is_flat[i] != 0) add_face(CountedDefect::ZeroAreaFaces, cut_.side.faces[i]);
    }
  }

  void add_pairs(UnweldedPairs unwelded) {
    elements_of(CountedDefect::IntersectingPairs).reserve(mesh_.intersecting_pairs().size());
    for (const IntersectingPair& pair : mesh_.intersecting_pairs()) {
      if (unwelded == UnweldedPairs::Ignore && pair.kind == ContactKind::Unwelded) continue;
      CountedElement& element = add(CountedDefect::IntersectingPairs);
      const auto [a, b] = std::minmax({face(pair.face_a), face(pair.face_b)});
      element.origins = {a, b};
      element.members = {pair.face_a, pair.face_b};
    }
  }

  [[nodiscard]] DefectInventory take() {
    std::size_t n_elements = 0;
    for (const std::vector<CountedElement>& elements : elements_) n_elements += elements.size();
    inventory_.elements.reserve(n_elements);
    for (std::size_t kind = 0; kind < elements_.size(); ++kind) {
      const std::vector<CountedElement> elements = sorted(std::exchange(elements_[kind], {}));
      inventory_.counts[kind] = elements.size();
      inventory_.elements.insert(inventory_.elements.end(), elements.begin(), elements.end());
    }
    answer_attributes();
    return std::move(inventory_);
  }

 private:
  [[nodiscard]] Index vertex(Index v) const {
    return vertex_identity(tracked_, tracked_.vertex_keys[v]);
  }
  [[nodiscard]] Index face(Index f) const { return face_identity(tracked_, tracked_.face_keys[f]); }
  [[nodiscard]] std::array<Index, 2> ends_of(HalfedgeHandle h) const { return file_ends(cut_, h); }

  /// Tells whether an edge has an end where a sheet was cut.
  [[nodiscard]] bool cuts_sheet(const std::array<Index, 2>& ends) const {
    return std::any_of(ends.begin(), ends.end(),
                       [&](Index v) { return tracked_.is_where_sheet_was_cut(v); });
  }

  [[nodiscard]] static std::vector<CountedElement> sorted(std::vector<CountedElement> elements) {
    if (!std::is_sorted(elements.begin(), elements.end())) {
      std::stable_sort(elements.begin(), elements.end());
    }
    return elements;
  }

  [[nodiscard]] std::vector<CountedElement>& elements_of(CountedDefect kind) {
    return elements_[static_cast<std::size_t>(kind)];
  }
  CountedElement& add(CountedDefect kind) {
    CountedElement& element = elements_of(kind).emplace_back();
    element.kind = kind;
    return element;
  }
  void add_vertex(CountedDefect kind, Index v) {
    CountedElement& element = add(kind);
    element.origins[0] = vertex(v);
    element.members[0] = v;
  }
  void add_edge(CountedDefect kind, const std::array<Index, 2>& ends) {
    CountedElement& element = add(kind);
    const auto [a, b] = std::minmax({vertex(ends[0]), vertex(ends[1])});
    element.origins = {a, b};
    element.members = ends;
  }
  void add_face(CountedDefect kind, Index f) {
    CountedElement& element = add(kind);
    element.origins[0] = face(f);
    element.members[0] = f;
  }
  void add_cut_edges(CountedDefect kind, const CutEdges& edges) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      add_edge(kind, ends_of(edges[i].halfedges.front()));
    }
  }

  /// Follows the report: an attribute that presupposes another one requires it.
  void answer_attributes() {
    const auto says_yes = [&](Attribute attribute, bool answer) {
      inventory_.is_yes[static_cast<std::size_t>(attribute)] = answer;
    };
    const bool has_faces = !cut_.side.faces.empty();
    const bool is_closed = has_faces && inventory_.count(CountedDefect::BorderEdges) == 0;
    const bool is_manifold = has_faces && cut_.side.non_manifold_edges.size() == 0 &&
                             cut_.side.non_manifold_vertices.empty();
    const bool is_consistent = is_manifold && cut_.side.flipped_edges.size() == 0;
    says_yes(Attribute::Closed, is_closed);
    says_yes(Attribute::Manifold, is_manifold);
    says_yes(Attribute::Consistent, is_consistent);
    says_yes(Attribute::Orientable,
             is_manifold && (is_consistent ||
                             find_orientability(cut_, find_edge_components(cut_)).orientable));
    says_yes(Attribute::Outward, is_closed && is_consistent && points_outward());
  }

  [[nodiscard]] bool points_outward() const {
    const std::vector<Shell>& shells = mesh_.shells();
    return std::all_of(shells.begin(), shells.end(),
                       [](const Shell& shell) { return shell.outward.value_or(false); });
  }

  const TrackedMesh& tracked_;
  const CutMesh& cut_;
  const PreparedMesh& mesh_;
  /// The elements of each kind.
  std::array<std::vector<CountedElement>, kCountedDefects> elements_;
  DefectInventory inventory_;
};

}  // namespace

Index vertex_identity(const TrackedMesh& tracked, Index key) {
  const Index origin = tracked.origin_of_vertex_key(key);
  return origin == kNoIndex ? key : origin;
}

Index face_identity(const TrackedMesh& tracked, Index key) {
  const Index origin = tracked.origin_of_key(key);
  return origin == kNoIndex ? key : origin;
}

ElementCorners corners_of(const TrackedMesh& tracked, const CountedElement& element) {
  const auto identity = [&](Index v) { return vertex_identity(tracked, tracked.vertex_keys[v]); };
  ElementCorners corners;
  corners.fill(kNoTriangle);
  const bool has_faces = element.kind == CountedDefect::IntersectingPairs ||
                         element.kind == CountedDefect::DuplicateFaces ||
                         element.kind == CountedDefect::ZeroAreaFaces;
  for (std::size_t i = 0; i < element.members.size(); ++i) {
    if (element.members[i] == kNoIndex) continue;
    if (!has_faces) {
      corners[0][i] = identity(element.members[i]);
      continue;
    }
    const Triangle& t = tracked.soup.triangles[element.members[i]];
    corners[i] = {identity(t[0]), identity(t[1]), identity(t[2])};
  }
  return corners;
}

DefectInventory list_defective(const TrackedMesh& tracked, const PreparedMesh& mesh,
                               const Tolerances& tolerances, UnweldedPairs unwelded) {
  Inventory inventory(tracked, mesh);
  inventory.add_topology();
  inventory.add_slits(tolerances);
  inventory.add_zero_areas();
  inventory.add_pairs(unwelded);
  return inventory.take();
}

}  // namespace meshalyzer
