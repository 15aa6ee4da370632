#include "meshalyzer/picture/internal/highlighted_elements.h"

#include "meshalyzer/picture/internal/drawn_surface.h"
#include "meshalyzer/picture/internal/worst_defects.h"

#include <algorithm>

namespace meshalyzer {
namespace {

/// Tells whether faces are too thin to be seen as faces.
bool is_thin(DefectCode code) {
  return code == DefectCode::FlatFacet || code == DefectCode::DegenerateFacet;
}

/// Returns the places of the first defects of each code.
std::vector<std::size_t> first_of_each_code(const DefectList& defects, std::size_t max) {
  std::array<std::size_t, kDefectCodes> taken{};
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < defects.size(); ++i) {
    if (taken[static_cast<std::size_t>(defects.code_of(i))]++ < max) places.push_back(i);
  }
  return places;
}

std::vector<Defect> unpack(const DefectList& defects, std::span<const std::size_t> places) {
  std::vector<Defect> unpacked;
  for (const std::size_t place : places) unpacked.push_back(defects[place]);
  return unpacked;
}

/// Lists all elements of some defects.
std::vector<HighlightedElements> elements_of(std::span<const Defect> defects,
                                             std::span<const std::size_t> places) {
  std::vector<HighlightedElements> elements;
  for (std::size_t i = 0; i < defects.size(); ++i) {
    const Defect& defect = defects[i];
    HighlightedElements& one = elements.emplace_back();
    one.number = places[i];
    one.faces = defect.faces;
    one.edges = defect.edges;
    one.pairs = defect.pairs;
    one.vertices = defect.vertices;
    one.positions = defect.positions;
    one.is_thin = is_thin(defect.code);
  }
  return elements;
}

/// Lists the faces of some components of the mesh.
class ComponentFaces {
 public:
  explicit ComponentFaces(const PreparedMesh& mesh)
      : cut_(mesh.cut()), components_(mesh.components()), list_of_(components_.count, kNoIndex) {}

  /// Returns the number of the list of the component to which a face belongs.
  Index list_of(Index face) {
    Index& list = list_of_[components_.of_face[cut_.side.mesh_face(face)]];
    if (list == kNoIndex) list = n_lists_++;
    return list;
  }

  /// Fills each list with the first faces that can be drawn, one more than may be highlighted, so
  /// that it is known that there are more.
  [[nodiscard]] std::vector<std::vector<Index>> fill(const Soup& soup, std::size_t max) const {
    std::vector<std::vector<Index>> lists(n_lists_);
    for (std::size_t f = 0; f < components_.of_face.size(); ++f) {
      const Index list = list_of_[components_.of_face[f]];
      const Index face = cut_.side.faces[f];
      if (list == kNoIndex || lists[list].size() > max) continue;
      if (is_drawable(soup, face)) lists[list].push_back(face);
    }
    return lists;
  }

 private:
  const CutMesh& cut_;
  const Components& components_;
  std::vector<Index> list_of_;
  Index n_lists_ = 0;
};

/// Gives each defect that is a component all faces of that component.
std::vector<std::vector<Index>> expand_components(const PreparedMesh& mesh,
                                                  std::span<const Defect> defects,
                                                  std::vector<HighlightedElements>& elements,
                                                  std::size_t max) {
  if (std::none_of(defects.begin(), defects.end(), names_component)) return {};
  ComponentFaces components(mesh);
  std::vector<Index> list_of(elements.size(), kNoIndex);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (names_component(defects[i])) list_of[i] = components.list_of(elements[i].faces[0]);
  }
  std::vector<std::vector<Index>> lists = components.fill(mesh.soup(), max);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (list_of[i] != kNoIndex) elements[i].faces = lists[list_of[i]];
  }
  return lists;
}

std::size_t size_of(const HighlightedElements& elements) {
  return std::max({elements.faces.size(), elements.edges.size(), elements.pairs.size(),
                   elements.vertices.size()});
}

void cut_to(HighlightedElements& elements, std::size_t max) {
  const auto cut = [max](auto& list) { list = list.first(std::min(list.size(), max)); };
  elements.is_cut = size_of(elements) > max;
  cut(elements.faces);
  cut(elements.edges);
  cut(elements.pairs);
  cut(elements.vertices);
}

/// Cuts all lists to the same size, so that together they keep the limit.
void cut_to_limits(std::vector<HighlightedElements>& all, const SceneLimits& limits) {
  std::vector<std::size_t> sizes;
  for (const HighlightedElements& elements : all) sizes.push_back(size_of(elements));
  const std::size_t share =
      fair_share(sizes, limits.max_elements_of_a_defect, limits.max_elements_of_all);
  for (HighlightedElements& elements : all) cut_to(elements, share);
}

/// Adds one element of each list of a defect to the seeds.
void add_seeds(const Soup& soup, const HighlightedElements& elements, std::size_t place,
               Seeds& seeds) {
  if (place < elements.faces.size() && is_drawable(soup, elements.faces[place])) {
    seeds.faces.push_back(elements.faces[place]);
  }
  if (place < elements.edges.size()) {
    seeds.vertices.insert(seeds.vertices.end(), elements.edges[place].begin(),
                          elements.edges[place].end());
  }
  if (place < elements.vertices.size()) seeds.vertices.push_back(elements.vertices[place]);
}

}  // namespace

std::size_t fair_share(std::span<const std::size_t> sizes, std::size_t max_each,
                       std::size_t total) {
  std::size_t low = 1;
  std::size_t high = std::max<std::size_t>(max_each, 1);
  while (low < high) {
    const std::size_t share = high - (high - low) / 2;
    std::size_t sum = 0;
    for (const std::size_t size : sizes) sum += std::min(size, share);
    if (sum <= total) {
      low = share;
    } else {
      high = share - 1;
    }
  }
  return low;
}

std::vector<HighlightedElements> elements_of_changes(std::span<const ChangedPlace> changes,
                                                     const SceneLimits& limits) {
  std::vector<HighlightedElements> elements;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    elements.push_back({.number = i,
                        .faces = changes[i].faces,
                        .edges = changes[i].edges,
                        .pairs = {},
                        .vertices = {},
                        .positions = {}});
  }
  cut_to_limits(elements, limits);
  return elements;
}

HighlightedDefects::HighlightedDefects(const PreparedMesh& mesh, const DefectReport& report,
                                       const SceneLimits& limits) {
  const std::vector<std::size_t> places =
      first_of_each_code(report.defects, limits.max_defects_of_a_code);
  defects_ = unpack(report.defects, places);
  elements_ = elements_of(defects_, places);
  components_ = expand_components(mesh, defects_, elements_, limits.max_elements_of_a_defect);
  cut_to_limits(elements_, limits);
}

Seeds HighlightedDefects::seeds(const Soup& soup) const {
  std::vector<const HighlightedElements*> left;
  for (const Severity severity : {Severity::Error, Severity::Warning}) {
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      if (defects_[i].severity == severity) left.push_back(&elements_[i]);
    }
  }
  Seeds seeds;
  for (std::size_t place = 0; !left.empty(); ++place) {
    for (const HighlightedElements* elements : left) add_seeds(soup, *elements, place, seeds);
    std::erase_if(
        left, [&](const HighlightedElements* elements) { return size_of(*elements) <= place + 1; });
  }
  return seeds;
}

}  // namespace meshalyzer
