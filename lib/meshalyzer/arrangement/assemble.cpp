#include "meshalyzer/arrangement/assemble.h"

#include "meshalyzer/arrangement/flat_faces.h"
#include "meshalyzer/base/parallel_sort.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace meshalyzer {
namespace {

/// Assembles an arrangement from its parts.
class Assembly {
 public:
  Assembly(const ArrangementParts& parts, Nodes nodes)
      : parts_(parts), soup_(parts.soup), nodes_(std::move(nodes)) {}

  Arrangement run() {
    for (const FaceSimplex& simplex : parts_.simplices) result_.cut_faces.push_back(simplex.face);
    number_vertices();
    collect_pieces();
    index_faces();
    collect_curves();
    return std::move(result_);
  }

 private:
  /// One piece of a cluster, ordered by its lowest face.
  struct ClusterPiece {
    Index face = kNoIndex;
    Index cluster = kNoIndex;
    Index number = kNoIndex;

    friend auto operator<=>(const ClusterPiece&, const ClusterPiece&) = default;
  };

  void number_vertices() {
    result_.n_input_vertices = soup_.n_vertices();
    result_.positions = soup_.positions;
    vertex_of_input_.resize(soup_.n_vertices());
    std::iota(vertex_of_input_.begin(), vertex_of_input_.end(), Index{0});
    vertex_of_node_.assign(nodes_.points.size(), kNoIndex);
    unite_input_vertices();
    std::vector<ExactPoint> made;
    made.reserve(nodes_.points.size());
    for (std::size_t node = 0; node < nodes_.points.size(); ++node) {
      if (vertex_of_node_[node] != kNoIndex) continue;
      vertex_of_node_[node] = static_cast<Index>(result_.positions.size());
      result_.positions.push_back(nodes_.points[node].rounded);
      made.push_back(std::move(nodes_.points[node]));
    }
    result_.exact = ExactVertices(std::move(made));
  }

  void unite_input_vertices() {
    const std::vector<std::uint8_t> stays = vertices_of_uncut_triangles();
    const auto& names = parts_.points.names();
    const auto for_each_corner = [&](const auto& body) {
      for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i].kind == PointKind::Vertex) body(names[i].of[0], nodes_.of_first[i]);
      }
    };
    // Names are sorted, so the lowest vertex comes first.
    for_each_corner([&](Index vertex, Index node) {
      if (stays[vertex] != 0 && vertex_of_node_[node] == kNoIndex) vertex_of_node_[node] = vertex;
    });
    for_each_corner([&](Index vertex, Index node) {
      if (vertex_of_node_[node] == kNoIndex) vertex_of_node_[node] = vertex;
      vertex_of_input_[vertex] = vertex_of_node_[node];
    });
    for (const Index face : parts_.flat_faces) {
      for (const Index v : soup_.triangles[face]) unite_with_node(v);
    }
  }

  /// Unites a corner of a face of no area that was not cut with the node at its position. Otherwise
  /// the node could have become another vertex that no other face shares.
  void unite_with_node(Index vertex) {
    const ExactPoint point = exact_point(soup_.positions[vertex]);
    const auto found = std::lower_bound(nodes_.points.begin(), nodes_.points.end(), point,
                                        [](const ExactPoint& a, const ExactPoint& b) {
                                          return compare_lexicographically(a, b) < 0;
                                        });
    if (found == nodes_.points.end() || compare_lexicographically(*found, point) != 0) return;
    const Index united = vertex_of_node_[static_cast<std::size_t>(found - nodes_.points.begin())];
    if (united != kNoIndex) vertex_of_input_[vertex] = united;
  }

  [[nodiscard]] std::vector<std::uint8_t> vertices_of_uncut_triangles() const {
    std::vector<std::uint8_t> used(soup_.n_vertices(), 0);
    for (Index f = 0; f < soup_.n_faces(); ++f) {
      if (!is_in_complex(soup_.triangles[f]) || is_cut(f) || is_flat(f)) continue;
      for (const Index v : soup_.triangles[f]) used[v] = 1;
    }
    return used;
  }

  [[nodiscard]] bool is_cut(Index face) const {
    return std::binary_search(result_.cut_faces.begin(), result_.cut_faces.end(), face);
  }

  [[nodiscard]] bool is_flat(Index face) const {
    return std::binary_search(parts_.flat_faces.begin(), parts_.flat_faces.end(), face);
  }

  void collect_pieces() {
    const std::vector<ClusterPiece> cut = cluster_pieces();
    auto next = cut.begin();
    auto flat = parts_.flat_faces.begin();
    for (Index f = 0; f < soup_.n_faces(); ++f) {
      for (; next != cut.end() && next->face == f; ++next) add(*next);
      const Triangle& t = soup_.triangles[f];
      if (!is_in_complex(t)) continue;
      if (flat != parts_.flat_faces.end() && *flat == f) {
        ++flat;
        for (const Triangle& piece : fill_flat_walk(walk_of(t))) add(piece, f);
      } else if (!is_cut(f)) {
        add(t, f);
      }
    }
  }

  [[nodiscard]] std::vector<ClusterPiece> cluster_pieces() const {
    std::vector<ClusterPiece> pieces;
    for (Index c = 0; c < parts_.clusters.size(); ++c) {
      const ClusterPieces& cluster = parts_.clusters[c];
      for (Index i = 0; i < cluster.triangles.size(); ++i) {
        pieces.push_back({cluster.sources[cluster.source_begin[i]].face, c, i});
      }
    }
    parallel_sort(pieces);
    return pieces;
  }

  void add(const ClusterPiece& piece) {
    const ClusterPieces& cluster = parts_.clusters[piece.cluster];
    const auto& corners = cluster.triangles[piece.number];
    result_.pieces.push_back(
        {vertex_of_node_[corners[0]], vertex_of_node_[corners[1]], vertex_of_node_[corners[2]]});
    for (Index i = cluster.source_begin[piece.number]; i < cluster.source_begin[piece.number + 1];
         ++i) {
      result_.sources.push_back(cluster.sources[i]);
    }
    end_sources();
  }

  void add(const Triangle& piece, Index face) {
    result_.pieces.push_back(piece);
    result_.sources.push_back({face, 1});
    end_sources();
  }

  void end_sources() { result_.source_begin.push_back(static_cast<Index>(result_.sources.size())); }

  /// Returns the closed walk round a face of no area, including the nodes on its edges.
  [[nodiscard]] std::vector<Index> walk_of(const Triangle& t) const {
    std::vector<Index> walk;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = t[i];
      const Index to = t[(i + 1) % 3];
      walk.push_back(vertex_of_input_[from]);
      append_nodes(from, to, walk);
    }
    return walk;
  }

  void append_nodes(Index from, Index to, std::vector<Index>& walk) const {
    const auto [low, high] = std::minmax(from, to);
    const VertexPair edge{low, high};
    const auto begin =
        std::lower_bound(parts_.edge_nodes.begin(), parts_.edge_nodes.end(), EdgeNode{edge, 0});
    std::vector<Index> inner;
    for (auto it = begin; it != parts_.edge_nodes.end() && it->edge == edge; ++it) {
      inner.push_back(it->node);
    }
    if (inner.empty()) return;
    const auto node_of = [&](Index v) {
      return nodes_.of_first[parts_.points.find(vertex_name(v))];
    };
    if (node_of(to) < node_of(from)) std::reverse(inner.begin(), inner.end());
    for (const Index node : inner) walk.push_back(vertex_of_node_[node]);
  }

  void index_faces() {
    result_.pieces_of_faces = ItemsByGroup(soup_.n_faces(), [&](const auto& use) {
      for (Index piece = 0; piece < result_.pieces.size(); ++piece) {
        for (const PieceSource& source : result_.sources_of(piece)) use(source.face, piece);
      }
    });
  }

  void collect_curves() {
    for (const ClusterPieces& cluster : parts_.clusters) {
      for (const auto& [a, b] : cluster.curves) {
        const auto [low, high] = std::minmax(vertex_of_node_[a], vertex_of_node_[b]);
        result_.curves.push_back({low, high});
      }
    }
    parallel_sort_unique(result_.curves);
  }

  const ArrangementParts& parts_;
  const Soup& soup_;
  Nodes nodes_;
  std::vector<Index> vertex_of_input_;
  std::vector<Index> vertex_of_node_;
  Arrangement result_;
};

}  // namespace

Arrangement assemble(const ArrangementParts& parts, Nodes nodes) {
  return Assembly(parts, std::move(nodes)).run();
}

}  // namespace meshalyzer
