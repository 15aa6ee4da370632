#include "meshalyzer/repair/split/contact_places.h"

#include "meshalyzer/repair/sort_unique.h"
#include "meshalyzer/topology/disjoint_sets.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

using Link = std::array<Index, 2>;

bool precedes(const Vec3& a, const Vec3& b) {
  return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
}

/// The corners of two faces that are at one place but not one vertex, and how many are at one
/// place.
struct SharedPlaces {
  std::vector<Link> links;
  std::size_t count = 0;
};

SharedPlaces shared_places(const Soup& soup, const IntersectingPair& pair) {
  SharedPlaces shared;
  for (const Index a : soup.triangles[pair.face_a]) {
    for (const Index b : soup.triangles[pair.face_b]) {
      if (soup.positions[a] != soup.positions[b]) continue;
      ++shared.count;
      if (a != b) shared.links.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  return shared;
}

/// Pairs of vertices at one place whose faces touch; ascending, each once.
std::vector<Link> find_links(const PreparedMesh& mesh) {
  std::vector<Link> links;
  for (const IntersectingPair& pair : mesh.intersecting_pairs()) {
    if (pair.kind != ContactKind::Unwelded && pair.kind != ContactKind::CoplanarOverlap) continue;
    const SharedPlaces shared = shared_places(mesh.soup(), pair);
    if (pair.kind == ContactKind::CoplanarOverlap && shared.count < 3) continue;
    links.insert(links.end(), shared.links.begin(), shared.links.end());
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

VertexStars stars_of(const PreparedMesh& mesh, const std::vector<Link>& links) {
  std::vector<Index> vertices;
  for (const Link& link : links) vertices.insert(vertices.end(), link.begin(), link.end());
  sort_unique(vertices);
  return {mesh.cut(), std::move(vertices)};
}

/// Where the border edges of each star end, in order of space.
std::vector<std::vector<Vec3>> border_ends(const Soup& soup, const VertexStars& stars) {
  std::vector<std::vector<Vec3>> ends(stars.size());
  for (std::size_t star = 0; star < stars.size(); ++star) {
    const std::vector<Spoke> spokes = find_spokes(soup, stars, star);
    for (std::size_t i = 0; i < spokes.size(); ++i) {
      const bool is_alone = (i == 0 || spokes[i - 1].other != spokes[i].other) &&
                            (i + 1 == spokes.size() || spokes[i + 1].other != spokes[i].other);
      if (is_alone) ends[star].push_back(soup.positions[spokes[i].other]);
    }
    std::sort(ends[star].begin(), ends[star].end(), precedes);
  }
  return ends;
}

bool have_common(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  for (auto p = a.begin(), q = b.begin(); p != a.end() && q != b.end();) {
    if (precedes(*p, *q)) {
      ++p;
    } else if (precedes(*q, *p)) {
      ++q;
    } else {
      return true;
    }
  }
  return false;
}

/// Sets of stars at one place that border edges join.
DisjointSets join_weldable(const Soup& soup, const VertexStars& stars,
                           const std::vector<Link>& links) {
  const auto ends = border_ends(soup, stars);
  DisjointSets sets(stars.size());
  for (const auto& [a, b] : links) {
    const std::size_t i = stars.star_of(a);
    const std::size_t j = stars.star_of(b);
    if (have_common(ends[i], ends[j])) sets.unite(static_cast<Index>(i), static_cast<Index>(j));
  }
  return sets;
}

/// Sorts links and their vertices by place.
class PlaceMaker {
 public:
  PlaceMaker(const Soup& soup, const VertexStars& stars, const std::vector<Link>& links)
      : stars_(stars), units_(join_weldable(soup, stars, links)), places_(stars.size()) {
    for (const auto& [a, b] : links) places_.unite(star(a), star(b));
  }

  [[nodiscard]] std::vector<ContactPlace> make(const std::vector<Link>& links) {
    number_units();
    for (const auto& [a, b] : links) {
      if (unit_[star(a)] == unit_[star(b)]) continue;
      const auto contact = std::minmax(unit_[star(a)], unit_[star(b)]);
      result_[place_[star(a)]].contacts.push_back({contact.first, contact.second});
    }
    for (ContactPlace& place : result_) {
      std::sort(place.contacts.begin(), place.contacts.end());
      place.contacts.erase(std::unique(place.contacts.begin(), place.contacts.end()),
                           place.contacts.end());
    }
    std::erase_if(result_, [](const ContactPlace& place) { return place.contacts.empty(); });
    return std::move(result_);
  }

 private:
  [[nodiscard]] Index star(Index vertex) const {
    return static_cast<Index>(stars_.star_of(vertex));
  }

  /// Sets are named by their lowest elements, so that all are numbered as they are met.
  void number_units() {
    place_.resize(stars_.size());
    unit_.resize(stars_.size());
    for (Index i = 0; i < stars_.size(); ++i) {
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
      units[unit_[i]].push_back(stars_.vertex(i));
    }
  }

  const VertexStars& stars_;
  DisjointSets units_;
  DisjointSets places_;
  /// By star: its place, and its unit there.
  std::vector<Index> place_;
  std::vector<Index> unit_;
  std::vector<ContactPlace> result_;
};

}  // namespace

ContactPlaces find_contact_places(const PreparedMesh& mesh) {
  const std::vector<Link> links = find_links(mesh);
  VertexStars stars = stars_of(mesh, links);
  std::vector<ContactPlace> places = PlaceMaker(mesh.soup(), stars, links).make(links);
  return {.stars = std::move(stars), .places = std::move(places)};
}

}  // namespace meshalyzer
