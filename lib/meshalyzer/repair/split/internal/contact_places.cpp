#include "meshalyzer/repair/split/internal/contact_places.h"

#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/lexicographic.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/repair/orient/bounds_solid.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace meshalyzer {
namespace {

using Link = std::array<Index, 2>;

/// Appends the corners of two faces that are at one position but not one vertex.
void append_links(const Soup& soup, const IntersectingPair& pair, std::vector<Link>& links) {
  for (const Index a : soup.triangles[pair.face_a]) {
    for (const Index b : soup.triangles[pair.face_b]) {
      if (a != b && soup.positions[a] == soup.positions[b]) {
        links.push_back({std::min(a, b), std::max(a, b)});
      }
    }
  }
}

/// Tells whether two faces cover each other.
bool coincide(const Soup& soup, const IntersectingPair& pair) {
  return pair.kind == ContactKind::CoplanarOverlap &&
         have_equal_corners(soup, pair.face_a, pair.face_b);
}

/// #file faces: 1 for those of components without a border.
std::vector<std::uint8_t> faces_of_closed_parts(const PreparedMesh& mesh) {
  const Components components = find_edge_components(mesh.cut());
  const std::vector<std::uint8_t> is_closed = which_are_closed(mesh.cut(), components);
  std::vector<std::uint8_t> of_face;
  for (const Index component :
       components_of_file_faces(mesh.cut(), components, mesh.soup().n_faces())) {
    of_face.push_back(component == kNoIndex ? 0 : is_closed[component]);
  }
  return of_face;
}

/// Tells whether two faces with their corners at the same places have them in the same cyclic
/// order.
bool have_same_direction(const Soup& soup, const IntersectingPair& pair) {
  const Corners a = corners_of(soup, pair.face_a);
  const Corners b = corners_of(soup, pair.face_b);
  const auto first = std::find(b.begin(), b.end(), a[0]) - b.begin();
  return b[static_cast<std::size_t>(first + 1) % 3] == a[1];
}

/// #file vertices: 1 for those of faces of closed parts that coincide and have the same direction.
/// Such parts do not only touch but overlap, so that cutting them leaves one.
std::vector<std::uint8_t> vertices_of_doubled_faces(const PreparedMesh& mesh) {
  const Soup& soup = mesh.soup();
  std::vector<std::uint8_t> is_doubled(soup.n_vertices(), 0);
  std::vector<std::uint8_t> is_closed;
  for (const IntersectingPair& pair : mesh.intersecting_pairs()) {
    if (!coincide(soup, pair) || !have_same_direction(soup, pair)) continue;
    if (is_closed.empty()) is_closed = faces_of_closed_parts(mesh);
    if (is_closed[pair.face_a] == 0 || is_closed[pair.face_b] == 0) continue;
    for (const Index face : {pair.face_a, pair.face_b}) {
      for (const Index v : soup.triangles[face]) is_doubled[v] = 1;
    }
  }
  return is_doubled;
}

/// Returns pairs of vertices at one place whose faces touch; ascending, each once.
std::vector<Link> find_links(const PreparedMesh& mesh) {
  const std::vector<std::uint8_t> is_doubled = vertices_of_doubled_faces(mesh);
  std::vector<Link> links;
  for (const IntersectingPair& pair : mesh.intersecting_pairs()) {
    if (pair.kind == ContactKind::Unwelded || coincide(mesh.soup(), pair)) {
      append_links(mesh.soup(), pair, links);
    }
  }
  std::erase_if(links, [&](const Link& link) {
    return is_doubled[link[0]] != 0 && is_doubled[link[1]] != 0;
  });
  sort_unique(links);
  return links;
}

IncidentFaces incident_faces_of(const PreparedMesh& mesh, const std::vector<Link>& links) {
  std::vector<Index> vertices;
  for (const Link& link : links) vertices.insert(vertices.end(), link.begin(), link.end());
  sort_unique(vertices);
  return {mesh.cut(), std::move(vertices)};
}

/// Lists where the border edges at each vertex end, sorted by position. Those along which sheets
/// were cut are left out, because joining them would undo the cut.
std::vector<std::vector<Vec3>> border_ends(const TrackedMesh& tracked,
                                           const IncidentFaces& incident) {
  const Soup& soup = tracked.soup;
  std::vector<std::vector<Vec3>> ends(incident.size());
  for (std::size_t entry = 0; entry < incident.size(); ++entry) {
    const std::vector<Spoke> spokes = find_spokes(soup, incident, entry);
    for (std::size_t i = 0; i < spokes.size(); ++i) {
      const bool is_alone = (i == 0 || spokes[i - 1].other != spokes[i].other) &&
                            (i + 1 == spokes.size() || spokes[i + 1].other != spokes[i].other);
      const bool is_cut = tracked.is_where_sheet_was_cut(incident.vertex(entry), spokes[i].other);
      if (is_alone && !is_cut) ends[entry].push_back(soup.positions[spokes[i].other]);
    }
    std::sort(ends[entry].begin(), ends[entry].end(), lexicographically_less);
  }
  return ends;
}

bool have_common(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  for (auto p = a.begin(), q = b.begin(); p != a.end() && q != b.end();) {
    if (lexicographically_less(*p, *q)) {
      ++p;
    } else if (lexicographically_less(*q, *p)) {
      ++q;
    } else {
      return true;
    }
  }
  return false;
}

/// Joins the vertices at one place that border edges at equal positions connect.
DisjointSets join_weldable(const TrackedMesh& tracked, const IncidentFaces& incident,
                           const std::vector<Link>& links) {
  const auto ends = border_ends(tracked, incident);
  DisjointSets sets(incident.size());
  for (const auto& [a, b] : links) {
    const std::size_t i = incident.entry_of(a);
    const std::size_t j = incident.entry_of(b);
    if (have_common(ends[i], ends[j])) sets.unite(static_cast<Index>(i), static_cast<Index>(j));
  }
  return sets;
}

/// Sorts links and their vertices by place.
class PlaceMaker {
 public:
  PlaceMaker(const TrackedMesh& tracked, const IncidentFaces& incident,
             const std::vector<Link>& links)
      : incident_(incident),
        units_(join_weldable(tracked, incident, links)),
        places_(incident.size()) {
    for (const auto& [a, b] : links) places_.unite(entry(a), entry(b));
  }

  [[nodiscard]] std::vector<ContactPlace> make(const std::vector<Link>& links) {
    number_units();
    for (const auto& [a, b] : links) {
      if (unit_[entry(a)] == unit_[entry(b)]) continue;
      const auto contact = std::minmax(unit_[entry(a)], unit_[entry(b)]);
      result_[place_[entry(a)]].contacts.push_back({contact.first, contact.second});
    }
    for (ContactPlace& place : result_) sort_unique(place.contacts);
    std::erase_if(result_, [](const ContactPlace& place) { return place.contacts.empty(); });
    return std::move(result_);
  }

 private:
  [[nodiscard]] Index entry(Index vertex) const {
    return static_cast<Index>(incident_.entry_of(vertex));
  }

  /// Sets are named by their lowest elements, so that they are numbered in the order of their first
  /// occurrence.
  void number_units() {
    place_.resize(incident_.size());
    unit_.resize(incident_.size());
    for (Index i = 0; i < incident_.size(); ++i) {
      const Index first = places_.find(i);
      if (first == i) {
        place_[i] = static_cast<Index>(result_.size());
        result_.emplace_back();
      }
      place_[i] = place_[first];
      auto& units = result_[place_[i]].units;
      const Index root = units_.find(i);
      if (root == i) {
        unit_[i] = static_cast<Index>(units.size());
        units.emplace_back();
      }
      unit_[i] = unit_[root];
      units[unit_[i]].push_back(incident_.vertex(i));
    }
  }

  const IncidentFaces& incident_;
  DisjointSets units_;
  DisjointSets places_;
  /// The place of each entry, and its unit there.
  std::vector<Index> place_;
  std::vector<Index> unit_;
  std::vector<ContactPlace> result_;
};

}  // namespace

ContactPlaces find_contact_places(const TrackedMesh& tracked, const PreparedMesh& mesh) {
  const std::vector<Link> links = find_links(mesh);
  IncidentFaces incident = incident_faces_of(mesh, links);
  std::vector<ContactPlace> places = PlaceMaker(tracked, incident, links).make(links);
  return {.incident = std::move(incident), .places = std::move(places)};
}

}  // namespace meshalyzer
