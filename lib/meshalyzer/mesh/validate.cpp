#include "meshalyzer/mesh/validate.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/mesh/unbuild.h"
#include "meshalyzer/mesh/validate_mesh.h"

#include <algorithm>
#include <fmt/format.h>
#include <span>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

/// One side of one face of the complex, by file indices.
struct Side {
  Index smaller = 0;
  Index larger = 0;
  Index face = 0;
  /// The number of the corner at which the side begins: 0, 1 or 2.
  Index corner = 0;

  friend auto operator<=>(const Side&, const Side&) = default;
};

using Edge = std::span<const Side>;

bool starts_at_smaller(const Side& side, const Soup& soup) {
  return soup.triangles[side.face][side.corner] == side.smaller;
}

/// Returns all sides of the complex, sorted by vertices, so that those of one edge are together,
/// then by faces.
std::vector<Side> sorted_sides(const Soup& soup) {
  std::vector<Side> sides;
  for (Index face = 0; face < soup.n_faces(); ++face) {
    const Triangle& t = soup.triangles[face];
    if (!is_in_complex(t)) continue;
    for (Index corner = 0; corner < 3; ++corner) {
      const auto [smaller, larger] = std::minmax(t[corner], t[(corner + 1) % 3]);
      sides.push_back({smaller, larger, face, corner});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// The edges of the file, each a run of sides, by the kind that they must have in the mesh.
struct Edges {
  std::vector<Edge> borders;
  std::vector<Edge> joined;
  std::vector<Edge> flipped;
  std::vector<Edge> non_manifold;
};

Edges sort_out_edges(std::span<const Side> sides, const Soup& soup) {
  Edges edges;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    const auto is_other = [&](const Side& s) {
      return std::tie(s.smaller, s.larger) != std::tie(sides[begin].smaller, sides[begin].larger);
    };
    end = static_cast<std::size_t>(
        std::find_if(sides.begin() + static_cast<std::ptrdiff_t>(begin), sides.end(), is_other) -
        sides.begin());
    const Edge edge = sides.subspan(begin, end - begin);
    if (edge.size() == 1) {
      edges.borders.push_back(edge);
    } else if (edge.size() > 2) {
      edges.non_manifold.push_back(edge);
    } else if (starts_at_smaller(edge[0], soup) == starts_at_smaller(edge[1], soup)) {
      edges.flipped.push_back(edge);
    } else {
      edges.joined.push_back(edge);
    }
  }
  return edges;
}

/// Sets of corners 3 face + i of the soup that can be reached from one another.
class CornerSets {
 public:
  explicit CornerSets(const Soup& soup) : soup_(soup), sets_(3 * soup.n_faces()) {}
  /// Joins the corners of the two faces of an edge at its smaller, and at its larger vertex.
  void join_across(Edge edge) {
    sets_.unite(corner_at(edge[0], edge[0].smaller), corner_at(edge[1], edge[0].smaller));
    sets_.unite(corner_at(edge[0], edge[0].larger), corner_at(edge[1], edge[0].larger));
  }
  /// Returns the number of sets that the corners at each vertex form.
  [[nodiscard]] std::vector<Index> sets_at_vertices() const {
    std::vector<Index> n(soup_.n_vertices(), 0);
    for (Index corner = 0; corner < 3 * soup_.n_faces(); ++corner) {
      const Triangle& t = soup_.triangles[corner / 3];
      if (is_in_complex(t) && sets_.is_lowest(corner)) ++n[t[corner % 3]];
    }
    return n;
  }

 private:
  [[nodiscard]] Index corner_at(const Side& side, Index vertex) const {
    const Triangle& t = soup_.triangles[side.face];
    return 3 * side.face + static_cast<Index>(std::find(t.begin(), t.end(), vertex) - t.begin());
  }

  const Soup& soup_;
  DisjointSets sets_;
};

std::vector<Index> expected_non_manifold_vertices(const Soup& soup, const Edges& edges) {
  CornerSets sets(soup);
  for (const Edge edge : edges.joined) sets.join_across(edge);
  for (const Edge edge : edges.flipped) sets.join_across(edge);
  std::vector<Index> n_fans = sets.sets_at_vertices();
  for (const Edge edge : edges.non_manifold) n_fans[edge[0].smaller] = n_fans[edge[0].larger] = 2;
  std::vector<Index> vertices;
  for (Index v = 0; v < n_fans.size(); ++v) {
    if (n_fans[v] > 1) vertices.push_back(v);
  }
  return vertices;
}

/// Compares a cut mesh with the soup that it should represent.
class Comparison {
 public:
  Comparison(const CutMesh& cut, const Soup& soup, Complaints& complaints)
      : mesh_(cut.mesh), side_(cut.side), cut_(cut), soup_(soup), complaints_(complaints) {}

  /// Checks the sizes of all arrays. If it finds a fault, nothing else can be checked.
  void check_sizes() {
    if (side_.n_file_vertices != soup_.n_vertices() ||
        mesh_.n_vertices() != soup_.n_vertices() + side_.copies.size()) {
      complaints_.add(fmt::format(
          "{} mesh vertices are said to be {} of the file's {} and {} copies", mesh_.n_vertices(),
          side_.n_file_vertices, soup_.n_vertices(), side_.copies.size()));
    }
    if (!std::is_sorted(side_.copies.begin(), side_.copies.end()) ||
        (!side_.copies.empty() && side_.copies.back() >= soup_.n_vertices())) {
      complaints_.add("the copies are not in order of their file vertices");
    }
    std::vector<Index> faces;
    std::vector<Index> rejected;
    for (Index face = 0; face < soup_.n_faces(); ++face) {
      (is_in_complex(soup_.triangles[face]) ? faces : rejected).push_back(face);
    }
    if (side_.faces != faces || mesh_.n_faces() != faces.size()) {
      complaints_.add(fmt::format(
          "{} mesh faces, {} of them in the side table, are not the {} faces of the complex",
          mesh_.n_faces(), side_.faces.size(), faces.size()));
    }
    if (side_.rejected_faces != rejected) {
      complaints_.add(fmt::format("{} rejected faces are not the {} that cannot be held",
                                  side_.rejected_faces.size(), rejected.size()));
    }
  }

  void check_faces() {
    const std::vector<Triangle> triangles = unbuild(cut_);
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      Triangle t = triangles[f];
      const Triangle& expected = soup_.triangles[side_.faces[f]];
      for (int turn = 0; turn < 3 && t != expected; ++turn) {
        std::rotate(t.begin(), t.begin() + 1, t.end());
      }
      if (t != expected) {
        complaints_.add(
            fmt::format("face {}: glued, it is not face {} of the file", f, side_.faces[f]));
      }
    }
  }

  /// Checks that each mesh vertex lies where its file vertex does, that the fan with the lowest
  /// face stays at the file's own vertex, and that the copies follow in order.
  void check_vertices() {
    for (const VertexHandle v : mesh_.all_vertices()) {
      if (mesh_.point(v) != soup_.positions[side_.vertex(v)]) {
        complaints_.add(fmt::format("vertex {}: it does not lie where vertex {} of the file does",
                                    v.idx(), side_.vertex(v)));
      }
    }
    std::vector<Index> lowest(mesh_.n_vertices(), kNoIndex);
    for (const HalfedgeHandle h : mesh_.all_halfedges()) {
      if (mesh_.is_boundary(h)) continue;
      Index& face = lowest[static_cast<std::size_t>(mesh_.to_vertex_handle(h).idx())];
      face = std::min(face, static_cast<Index>(mesh_.face_handle(h).idx()));
    }
    for (std::size_t i = 0; i < side_.copies.size(); ++i) {
      const std::size_t copy = side_.n_file_vertices + i;
      const bool is_first = i == 0 || side_.copies[i - 1] != side_.copies[i];
      if (lowest[copy] == kNoIndex ||
          lowest[is_first ? side_.copies[i] : copy - 1] >= lowest[copy]) {
        complaints_.add(fmt::format("vertex {}: a copy of vertex {} out of order, or without faces",
                                    copy, side_.copies[i]));
      }
    }
  }

  /// Checks that the mesh joins the faces at exactly those edges where it can.
  void check_edges(const Edges& edges) {
    for (const Edge edge : edges.joined) {
      const HalfedgeHandle opposite = mesh_.opposite_halfedge_handle(halfedge_of(edge[0]));
      if (opposite != halfedge_of(edge[1])) say(edge, "is cut, though its two faces agree");
    }
    for (const auto* cuts : {&edges.borders, &edges.flipped, &edges.non_manifold}) {
      for (const Edge edge : *cuts) {
        for (const Side& side : edge) {
          if (!mesh_.is_boundary(mesh_.opposite_halfedge_handle(halfedge_of(side)))) {
            say(edge, "is not a border");
          }
        }
      }
    }
  }

  void check_cut_edges(const CutEdges& listed, const std::vector<Edge>& expected,
                       std::string_view name) {
    if (!is_list(listed) || listed.size() != expected.size()) {
      complaints_.add(
          fmt::format("{} {} edges are listed where {} are", listed.size(), name, expected.size()));
      return;
    }
    for (std::size_t i = 0; i < expected.size(); ++i) {
      std::vector<HalfedgeHandle> halfedges;
      for (const Side& side : expected[i]) halfedges.push_back(halfedge_of(side));
      if (!std::ranges::equal(listed[i].halfedges, halfedges)) {
        say(expected[i], fmt::format("is not listed with its half-edges among the {} edges", name));
      }
    }
  }

  void check_non_manifold_vertices(const Edges& edges) {
    const std::vector<Index> expected = expected_non_manifold_vertices(soup_, edges);
    if (side_.non_manifold_vertices != expected) {
      complaints_.add(fmt::format("the {} non-manifold vertices listed are not the {} that are",
                                  side_.non_manifold_vertices.size(), expected.size()));
    }
  }

 private:
  static bool is_list(const CutEdges& edges) {
    return !edges.begin.empty() && edges.begin.front() == 0 &&
           edges.begin.back() == edges.halfedges.size() &&
           std::is_sorted(edges.begin.begin(), edges.begin.end());
  }

  /// Returns the mesh's half-edge of a side, found by its vertices, or an invalid one if its face
  /// has no such half-edge.
  [[nodiscard]] HalfedgeHandle halfedge_of(const Side& side) const {
    const auto place =
        std::lower_bound(side_.faces.begin(), side_.faces.end(), side.face) - side_.faces.begin();
    const Index from = soup_.triangles[side.face][side.corner];
    HalfedgeHandle h = mesh_.halfedge_handle(FaceHandle(static_cast<int>(place)));
    for (int turn = 0; turn < 3 && side_.vertex(mesh_.from_vertex_handle(h)) != from; ++turn) {
      h = mesh_.next_halfedge_handle(h);
    }
    return h;
  }

  void say(Edge edge, std::string_view what) {
    complaints_.add(
        fmt::format("edge {} {} of the file {}", edge[0].smaller, edge[0].larger, what));
  }

  const TriMesh& mesh_;
  const SideTable& side_;
  const CutMesh& cut_;
  const Soup& soup_;
  Complaints& complaints_;
};

}  // namespace

std::vector<std::string> validate(const CutMesh& cut, const Soup& soup, std::size_t max_messages) {
  Complaints complaints(max_messages);
  validate_mesh(cut.mesh, complaints);
  Comparison comparison(cut, soup, complaints);
  if (complaints.none()) comparison.check_sizes();
  if (complaints.none()) comparison.check_faces();
  // From here on each face of the mesh is known to be the file's.
  if (complaints.none()) {
    const std::vector<Side> sides = sorted_sides(soup);
    const Edges edges = sort_out_edges(sides, soup);
    comparison.check_vertices();
    comparison.check_edges(edges);
    comparison.check_cut_edges(cut.side.non_manifold_edges, edges.non_manifold, "non-manifold");
    comparison.check_cut_edges(cut.side.flipped_edges, edges.flipped, "flipped");
    comparison.check_non_manifold_vertices(edges);
  }
  return std::move(complaints).sentences();
}

}  // namespace meshalyzer
