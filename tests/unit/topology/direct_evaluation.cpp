#include "direct_evaluation.h"

#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <functional>
#include <random>

namespace meshalyzer::direct {
namespace {

std::array<Edge, 3> edges_of(const Triangle& t) {
  return {std::minmax(t[0], t[1]), std::minmax(t[1], t[2]), std::minmax(t[2], t[0])};
}

bool has_vertex(const Triangle& t, Index v) {
  return std::find(t.begin(), t.end(), v) != t.end();
}

/// Tells whether a face runs along an edge from its smaller to its larger vertex.
bool runs_upwards(const Triangle& t, const Edge& edge) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (t[k] == edge.first && t[(k + 1) % 3] == edge.second) return true;
  }
  return false;
}

/// Numbers for n items: the same for two that are related, directly or through others.
std::vector<Index> classes(std::size_t n,
                           const std::function<bool(std::size_t, std::size_t)>& related) {
  std::vector<Index> number(n, kNoIndex);
  Index count = 0;
  for (std::size_t seed = 0; seed < n; ++seed) {
    if (number[seed] != kNoIndex) continue;
    std::vector<std::size_t> open{seed};
    number[seed] = count;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      for (std::size_t i = 0; i < n; ++i) {
        if (number[i] != kNoIndex || !related(at, i)) continue;
        number[i] = count;
        open.push_back(i);
      }
    }
    ++count;
  }
  return number;
}

/// The faces at a vertex, and the fan that each of them is in.
struct Fans {
  std::vector<std::size_t> faces;
  std::vector<Index> fan_of;
};

Fans fans_at(const Complex& complex, Index v) {
  Fans fans;
  for (std::size_t f = 0; f < complex.triangles.size(); ++f) {
    if (has_vertex(complex.triangles[f], v)) fans.faces.push_back(f);
  }
  fans.fan_of = classes(fans.faces.size(), [&](std::size_t i, std::size_t j) {
    for (const auto& [edge, faces] : complex.faces_at) {
      const bool is_here = edge.first == v || edge.second == v;
      if (!is_here || faces.size() != 2) continue;
      const auto pair = std::minmax(fans.faces[i], fans.faces[j]);
      if (faces[0] == pair.first && faces[1] == pair.second) return true;
    }
    return false;
  });
  return fans;
}

std::set<Index> used_vertices(const Complex& complex) {
  std::set<Index> vertices;
  for (const Triangle& t : complex.triangles) vertices.insert(t.begin(), t.end());
  return vertices;
}

}  // namespace

Complex complex_of(const Soup& soup) {
  Complex complex;
  for (const Triangle& t : soup.triangles) {
    if (!is_in_complex(t)) continue;
    for (const Edge& edge : edges_of(t)) {
      complex.faces_at[edge].push_back(complex.triangles.size());
    }
    complex.triangles.push_back(t);
  }
  return complex;
}

std::set<Edge> edges_with(const Complex& complex, std::size_t n_faces) {
  std::set<Edge> edges;
  for (const auto& [edge, faces] : complex.faces_at) {
    if (faces.size() == n_faces) edges.insert(edge);
  }
  return edges;
}

std::vector<Index> components(const Complex& complex) {
  const auto& triangles = complex.triangles;
  return classes(triangles.size(), [&](std::size_t i, std::size_t j) {
    return std::any_of(triangles[i].begin(), triangles[i].end(),
                       [&](Index v) { return has_vertex(triangles[j], v); });
  });
}

std::vector<Index> edge_components(const Complex& complex) {
  return classes(complex.triangles.size(), [&](std::size_t i, std::size_t j) {
    for (const Edge& a : edges_of(complex.triangles[i])) {
      for (const Edge& b : edges_of(complex.triangles[j])) {
        if (a == b) return true;
      }
    }
    return false;
  });
}

std::set<std::set<Edge>> boundaries(const Complex& complex) {
  const std::set<Edge> border = edges_with(complex, 1);
  const std::vector<Edge> edges(border.begin(), border.end());
  std::set<std::pair<Edge, Edge>> neighbours;
  for (const Index v : used_vertices(complex)) {
    const Fans fans = fans_at(complex, v);
    const auto fan = [&](const Edge& edge) {
      const std::size_t face = complex.faces_at.at(edge)[0];
      const auto place = std::find(fans.faces.begin(), fans.faces.end(), face);
      return fans.fan_of[static_cast<std::size_t>(place - fans.faces.begin())];
    };
    const auto is_here = [&](const Edge& edge) { return edge.first == v || edge.second == v; };
    for (const Edge& a : edges) {
      for (const Edge& b : edges) {
        if (is_here(a) && is_here(b) && fan(a) == fan(b)) neighbours.insert({a, b});
      }
    }
  }
  const std::vector<Index> number = classes(edges.size(), [&](std::size_t i, std::size_t j) {
    return neighbours.count({edges[i], edges[j]}) != 0;
  });
  std::map<Index, std::set<Edge>> by_number;
  for (std::size_t i = 0; i < edges.size(); ++i) by_number[number[i]].insert(edges[i]);
  std::set<std::set<Edge>> result;
  for (const auto& [n, members] : by_number) result.insert(members);
  return result;
}

std::vector<Index> pinched_vertices(const Complex& complex) {
  std::set<Index> on_crowded_edges;
  for (const auto& [edge, faces] : complex.faces_at) {
    if (faces.size() > 2) on_crowded_edges.insert({edge.first, edge.second});
  }
  std::vector<Index> pinched;
  for (const Index v : used_vertices(complex)) {
    const std::vector<Index> fan_of = fans_at(complex, v).fan_of;
    const bool has_several = *std::max_element(fan_of.begin(), fan_of.end()) > 0;
    if (has_several && on_crowded_edges.count(v) == 0) pinched.push_back(v);
  }
  return pinched;
}

bool is_orientable(const Complex& complex, Index edge_component) {
  const std::vector<Index> component = edge_components(complex);
  for (std::size_t choice = 0; choice < std::size_t{1} << complex.triangles.size(); ++choice) {
    const auto upwards = [&](std::size_t f, const Edge& edge) {
      return runs_upwards(complex.triangles[f], edge) != ((choice >> f & 1U) != 0);
    };
    const bool is_consistent =
        std::all_of(complex.faces_at.begin(), complex.faces_at.end(), [&](const auto& at) {
          const auto& [edge, faces] = at;
          if (faces.size() != 2 || component[faces[0]] != edge_component) return true;
          return upwards(faces[0], edge) != upwards(faces[1], edge);
        });
    if (is_consistent) return true;
  }
  return false;
}

Soup random_soup(std::uint32_t seed, std::size_t n_faces) {
  std::mt19937 random(seed);
  Soup soup;
  soup.positions.assign(4 + random() % 9, Vec3::Zero());
  for (std::size_t f = 0; f < n_faces; ++f) {
    Triangle& t = soup.triangles.emplace_back();
    for (Index& corner : t) corner = static_cast<Index>(random() % soup.positions.size());
    if (random() % 20 == 0) t[random() % 3] = kNoIndex;
  }
  return soup;
}

Edge edge_of(const CutMesh& cut, HalfedgeHandle halfedge) {
  const auto [from, to] = file_ends(cut, halfedge);
  return std::minmax(from, to);
}

}  // namespace meshalyzer::direct
