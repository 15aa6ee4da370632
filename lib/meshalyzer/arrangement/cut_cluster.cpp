#include "meshalyzer/arrangement/cut_cluster.h"

#include "meshalyzer/arrangement/flip_edges.h"
#include "meshalyzer/arrangement/insert_segment.h"
#include "meshalyzer/arrangement/plane_cover.h"
#include "meshalyzer/arrangement/triangulate_hull.h"
#include "meshalyzer/base/sort_unique.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {
namespace {

/// With fewer points segments cross few triangles of any shape, so that flipping edges does not
/// pay.
constexpr std::size_t kManyPoints = 16;

/// Cuts the faces of one cluster.
class ClusterCut {
 public:
  ClusterCut(const CuttingScene& scene, const FaceCluster& cluster, std::span<const Index> nodes)
      : scene_(scene), cluster_(cluster), local_(nodes) {}

  ClusterPieces run() {
    triangulate();
    insert_faces();
    insert_segments();
    flip_edges(t_);
    if (cluster_.faces.size() == 1) {
      take_all();
    } else {
      take_covered();
    }
    return std::move(pieces_);
  }

 private:
  void triangulate() {
    std::vector<const ExactPoint*> points;
    points.reserve(local_.size());
    for (const Index node : local_) points.push_back(&scene_.nodes.points[node]);
    t_ = triangulate_hull(cluster_.axis, std::move(points));
    if (local_.size() >= kManyPoints) flip_edges(t_);
  }

  /// Returns the number in the triangulation of a point of contacts.
  [[nodiscard]] Index local(Index point) const {
    const Index node = scene_.nodes.of_first[point];
    return static_cast<Index>(std::lower_bound(local_.begin(), local_.end(), node) -
                              local_.begin());
  }
  [[nodiscard]] Index local_corner(Index vertex) const {
    return local(scene_.points.find(vertex_name(vertex)));
  }

  void insert_faces() {
    for (const Index number : cluster_.faces) {
      const FaceSimplex& face = scene_.simplices[number];
      for (const VertexPair& edge : face.edges()) {
        const std::vector<Index> chain =
            insert_segment(t_, local_corner(edge[0]), local_corner(edge[1]));
        note_edge_nodes(edge, chain);
        if (cluster_.faces.size() > 1) note_border(number, chain);
      }
    }
  }

  void note_edge_nodes(VertexPair edge, std::span<const Index> chain) {
    if (edge[1] < edge[0]) std::swap(edge[0], edge[1]);
    if (!std::binary_search(scene_.flat_edges.begin(), scene_.flat_edges.end(), edge)) return;
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      pieces_.edge_nodes.push_back({edge, local_[chain[i]]});
    }
  }

  void note_border(Index number, std::span<const Index> chain) {
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const auto [low, high] = std::minmax(chain[i - 1], chain[i]);
      borders_.push_back({{low, high}, number});
    }
  }

  void insert_segments() {
    for (const ClusterSegment& segment : cluster_.segments) {
      const Index from = local(segment.from);
      const Index to = local(segment.to);
      if (from == to) continue;
      const std::vector<Index> chain = insert_segment(t_, from, to);
      for (std::size_t i = 1; i < chain.size(); ++i) {
        const auto [low, high] = std::minmax(local_[chain[i - 1]], local_[chain[i]]);
        pieces_.curves.push_back({low, high});
      }
    }
    sort_unique(pieces_.curves);
  }

  /// Returns the turn of a face in the projection.
  [[nodiscard]] Sign turn_of(Index number) const {
    const Triangle& v = scene_.simplices[number].vertices;
    return t_.turn(local_corner(v[0]), local_corner(v[1]), local_corner(v[2]));
  }

  void take_all() {
    const std::array<PieceSource, 1> source{
        PieceSource{scene_.simplices[cluster_.faces[0]].face, turn_of(cluster_.faces[0])}};
    for (std::size_t i = 0; i < t_.n_triangles(); ++i) take(i, source);
  }

  void take_covered() {
    const PlaneCover cover = cover_by_borders(t_, std::move(borders_));
    std::vector<Sign> turns;
    for (const Index number : cluster_.faces) turns.push_back(turn_of(number));
    std::vector<PieceSource> sources;
    for (std::size_t i = 0; i < t_.n_triangles(); ++i) {
      sources.clear();
      for (const Index number : cover.of(i)) {
        const auto k = std::lower_bound(cluster_.faces.begin(), cluster_.faces.end(), number) -
                       cluster_.faces.begin();
        sources.push_back({scene_.simplices[number].face, turns[static_cast<std::size_t>(k)]});
      }
      if (!sources.empty()) take(i, sources);
    }
  }

  /// Makes a piece of a triangle, with the orientation of its first source.
  void take(std::size_t triangle, std::span<const PieceSource> sources) {
    const auto h = static_cast<Index>(3 * triangle);
    std::array<Index, 3> corners{local_[t_.origin[h]], local_[t_.origin[h + 1]],
                                 local_[t_.origin[h + 2]]};
    const Sign sign = sources.front().sign;
    if (sign < 0) std::swap(corners[1], corners[2]);
    pieces_.triangles.push_back(corners);
    for (const PieceSource& source : sources) {
      pieces_.sources.push_back({source.face, source.sign * sign});
    }
    pieces_.source_begin.push_back(static_cast<Index>(pieces_.sources.size()));
  }

  const CuttingScene& scene_;
  const FaceCluster& cluster_;
  /// The node of each vertex of the triangulation, ascending.
  std::span<const Index> local_;
  Triangulation t_;
  std::vector<BorderEdge> borders_;
  ClusterPieces pieces_;
};

}  // namespace

ClusterPieces cut_cluster(const CuttingScene& scene, const FaceCluster& cluster,
                          std::span<const Index> nodes) {
  return ClusterCut(scene, cluster, nodes).run();
}

}  // namespace meshalyzer
