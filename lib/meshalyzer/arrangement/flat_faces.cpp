#include "meshalyzer/arrangement/flat_faces.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"

#include <algorithm>

namespace meshalyzer {
namespace {

/// Removes from a closed walk one step that stays at its vertex, or two that go back and forth.
/// @return  Whether there was such a step.
bool shorten(std::vector<Index>& walk) {
  const std::size_t n = walk.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t first = (i + 1) % n;
    const std::size_t second = (i + 2) % n;
    const bool stays = walk[first] == walk[i];
    if (!stays && walk[second] != walk[i]) continue;
    walk.erase(walk.begin() + static_cast<std::ptrdiff_t>(stays ? first : std::max(first, second)));
    if (!stays) walk.erase(walk.begin() + static_cast<std::ptrdiff_t>(std::min(first, second)));
    return true;
  }
  return false;
}

}  // namespace

std::vector<Index> find_flat_faces(const Soup& soup) {
  return parallel_filter(soup.n_faces(), [&](Index face) {
    return is_in_complex(soup.triangles[face]) && are_collinear(corners_of(soup, face));
  });
}

std::vector<VertexPair> edges_of_faces(const Soup& soup, std::span<const Index> faces) {
  std::vector<VertexPair> edges;
  for (const Index face : faces) {
    const Triangle& t = soup.triangles[face];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
      edges.push_back({low, high});
    }
  }
  sort_unique(edges);
  return edges;
}

std::vector<EdgeNode> find_edge_nodes(std::span<const FaceSimplex> simplices,
                                      const FaceContacts& contacts, const NamedPoints& points,
                                      const Nodes& nodes) {
  std::vector<EdgeNode> found;
  const auto corner = [&](Index v) { return nodes.of_first[points.find(vertex_name(v))]; };
  for (const auto& [face, point] : contacts.points) {
    const FaceSimplex& simplex = simplices[simplex_number(simplices, face)];
    if (simplex.is_triangle()) continue;
    const Index node = nodes.of_first[points.find(point)];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [u, v] = std::minmax(simplex.vertices[i], simplex.vertices[(i + 1) % 3]);
      // All nodes are collinear and sorted along the line.
      const auto [low, high] = std::minmax({corner(u), corner(v)});
      if (low < node && node < high) found.push_back({{u, v}, node});
    }
  }
  return found;
}

std::vector<Triangle> fill_flat_walk(std::vector<Index> walk) {
  while (walk.size() > 2 && shorten(walk)) {
  }
  std::vector<Triangle> triangles;
  for (std::size_t i = 1; i + 1 < walk.size(); ++i) {
    const Triangle t{walk[0], walk[i], walk[i + 1]};
    if (is_in_complex(t)) triangles.push_back(t);
  }
  return triangles;
}

}  // namespace meshalyzer
