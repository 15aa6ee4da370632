#include "meshalyzer/arrangement/arrange.h"

#include "meshalyzer/arrangement/assemble.h"
#include "meshalyzer/arrangement/flat_faces.h"
#include "meshalyzer/arrangement/point_digits.h"
#include "meshalyzer/arrangement/segment_crossings.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/parallel_sort.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/mesh/finite_positions.h"
#include "meshalyzer/spatial/self_intersection.h"

#include <atomic>
#include <utility>

namespace meshalyzer {
namespace {

/// Items in one task: each cluster or pair takes some ten microseconds.
constexpr std::size_t kItemsAtOnce = 64;

void require_faces(const Soup& soup, std::span<const IntersectingPair> pairs) {
  for (const IntersectingPair& pair : pairs) {
    for (const Index face : {pair.face_a, pair.face_b}) {
      if (face >= soup.n_faces() || !is_in_complex(soup.triangles[face])) {
        throw InvalidArgument("arrange: a pair names a face that is in no complex");
      }
    }
  }
}

/// Once it is to stop, the results of these steps mean nothing.
FaceContacts find_contacts(const Soup& soup, std::span<const FaceSimplex> simplices,
                           std::span<const IntersectingPair> pairs,
                           const StopQuery& wants_to_stop) {
  std::vector<FaceContacts> parts(n_chunks(pairs.size(), kItemsAtOnce));
  parallel_chunks(pairs.size(), kItemsAtOnce, [&](Chunk chunk) {
    if (wants_to_stop()) return;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const FaceSimplex& a = simplices[simplex_number(simplices, pairs[i].face_a)];
      const FaceSimplex& b = simplices[simplex_number(simplices, pairs[i].face_b)];
      find_face_contact(soup, a, b, parts[chunk.number]);
    }
  });
  FaceContacts all;
  for (FaceContacts& part : parts) {
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
    all.segments.insert(all.segments.end(), part.segments.begin(), part.segments.end());
    part = {};
  }
  return all;
}

std::vector<PointName> names_of_contacts(std::span<const FaceSimplex> simplices,
                                         const FaceContacts& contacts) {
  std::vector<PointName> names;
  for (const FaceSimplex& simplex : simplices) {
    for (const Index v : simplex.vertices) names.push_back(vertex_name(v));
  }
  for (const ContactPoint& point : contacts.points) names.push_back(point.point);
  parallel_sort_unique(names);
  return names;
}

/// Returns the crossings in each cluster, or nothing if there are too many, or once it is to stop.
std::optional<std::vector<std::vector<PointName>>> find_crossings(
    std::span<const FaceSimplex> simplices, std::span<const FaceCluster> clusters,
    const NamedPoints& points, const ArrangeLimits& limits) {
  std::vector<std::vector<PointName>> crossings(clusters.size());
  std::atomic<std::size_t> n_found = 0;
  const auto are_too_many = [&] { return n_found > limits.max_crossings; };
  parallel_chunks(clusters.size(), kItemsAtOnce, [&](Chunk chunk) {
    if (limits.wants_to_stop()) return;
    for (std::size_t i = chunk.begin; i < chunk.end && !are_too_many(); ++i) {
      crossings[i] = find_segment_crossings(simplices, clusters[i], points, limits.max_crossings,
                                            limits.wants_to_stop);
      n_found += crossings[i].size();
    }
  });
  if (are_too_many() || limits.wants_to_stop()) return std::nullopt;
  return crossings;
}

std::vector<PointName> names_of_crossings(std::span<const std::vector<PointName>> crossings) {
  std::vector<PointName> names;
  for (const auto& some : crossings) names.insert(names.end(), some.begin(), some.end());
  parallel_sort_unique(names);
  return names;
}

/// The nodes in a cluster.
struct ClusterNodes {
  /// Ascending.
  std::vector<Index> all;
  /// The number of those that only crossings have made.
  std::size_t n_of_crossings = 0;
};

/// Returns the nodes in each cluster.
///
/// @param crossings  #clusters: the crossings in each.
std::vector<ClusterNodes> find_nodes(std::span<const FaceCluster> clusters,
                                     std::span<const std::vector<PointName>> crossings,
                                     const NamedPoints& crossing_points, const Nodes& nodes) {
  std::vector<ClusterNodes> nodes_of(clusters.size());
  parallel_chunks(clusters.size(), kItemsAtOnce, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      std::vector<Index>& all = nodes_of[i].all;
      for (const Index p : clusters[i].points) all.push_back(nodes.of_first[p]);
      sort_unique(all);
      const std::size_t n_of_contacts = all.size();
      for (const PointName& name : crossings[i]) {
        all.push_back(nodes.of_second[crossing_points.find(name)]);
      }
      sort_unique(all);
      nodes_of[i].n_of_crossings = all.size() - n_of_contacts;
    }
  });
  return nodes_of;
}

/// Returns a lower bound of the number of pieces. The faces of a cluster are joined through areas,
/// so that there is a spanning tree of their pieces, along whose edges each adds at most one node
/// to the three of the first. A triangulation has one more piece for each node inside it. Those
/// that only crossings have made are inside, if the face is a single one: on its edge, both
/// segments would lie along that.
std::size_t least_pieces(std::span<const FaceCluster> clusters,
                         std::span<const ClusterNodes> nodes_of_clusters) {
  std::size_t n_pieces = 0;
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    n_pieces += nodes_of_clusters[i].all.size() - 2;
    if (clusters[i].faces.size() == 1) n_pieces += nodes_of_clusters[i].n_of_crossings;
  }
  return n_pieces;
}

std::vector<ClusterPieces> cut_clusters(const CuttingScene& scene,
                                        std::span<const FaceCluster> clusters,
                                        std::span<const ClusterNodes> nodes_of_clusters,
                                        const StopQuery& wants_to_stop) {
  std::vector<ClusterPieces> pieces(clusters.size());
  parallel_chunks(clusters.size(), kItemsAtOnce, [&](Chunk chunk) {
    if (wants_to_stop()) return;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      pieces[i] = cut_cluster(scene, clusters[i], nodes_of_clusters[i].all);
    }
  });
  return pieces;
}

/// Collects the nodes on the edges of faces of no area, from their neighbours and from the faces
/// themselves.
std::vector<EdgeNode> collect_edge_nodes(std::vector<EdgeNode> own,
                                         std::span<const ClusterPieces> clusters) {
  for (const ClusterPieces& cluster : clusters) {
    own.insert(own.end(), cluster.edge_nodes.begin(), cluster.edge_nodes.end());
  }
  sort_unique(own);
  return own;
}

}  // namespace

Arrangement arrange(const Soup& soup, std::span<const IntersectingPair> pairs) {
  return *arrange_within(soup, pairs, ArrangeLimits{});
}

std::optional<Arrangement> arrange_within(const Soup& soup, std::span<const IntersectingPair> pairs,
                                          const ArrangeLimits& limits) {
  const StopQuery& wants_to_stop = limits.wants_to_stop;
  require_faces(soup, pairs);
  const std::vector<FaceSimplex> simplices = simplices_of(soup, pairs);
  const FaceContacts contacts = find_contacts(soup, simplices, pairs, wants_to_stop);
  if (wants_to_stop()) return std::nullopt;
  std::vector<PointName> names = names_of_contacts(simplices, contacts);
  if (most_digit_bytes(soup, names) > limits.max_digit_bytes) return std::nullopt;
  const NamedPoints points(soup, std::move(names));
  const std::vector<FaceCluster> clusters = make_clusters(simplices, pairs, contacts, points);
  const auto crossings = find_crossings(simplices, clusters, points, limits);
  if (!crossings) return std::nullopt;
  names = names_of_crossings(*crossings);
  if (most_digit_bytes(soup, names) > limits.max_digit_bytes) return std::nullopt;
  const NamedPoints crossing_points(soup, std::move(names));
  Nodes nodes = unite_points(points, crossing_points);
  if (nodes.points.size() > soup.n_vertices() &&
      nodes.points.size() - soup.n_vertices() > limits.max_pieces) {
    return std::nullopt;
  }
  const auto nodes_of_clusters = find_nodes(clusters, *crossings, crossing_points, nodes);
  if (least_pieces(clusters, nodes_of_clusters) > limits.max_pieces) return std::nullopt;

  const std::vector<Index> flat_faces = find_flat_faces(soup);
  const std::vector<VertexPair> flat_edges = edges_of_faces(soup, flat_faces);
  const std::vector<ClusterPieces> pieces = cut_clusters(
      {.simplices = simplices, .points = points, .nodes = nodes, .flat_edges = flat_edges},
      clusters, nodes_of_clusters, wants_to_stop);
  if (wants_to_stop()) return std::nullopt;
  const std::vector<EdgeNode> edge_nodes =
      collect_edge_nodes(find_edge_nodes(simplices, contacts, points, nodes), pieces);
  Arrangement arrangement = assemble({.soup = soup,
                                      .simplices = simplices,
                                      .points = points,
                                      .clusters = pieces,
                                      .flat_faces = flat_faces,
                                      .edge_nodes = edge_nodes},
                                     std::move(nodes));
  if (arrangement.pieces.size() > limits.max_pieces) return std::nullopt;
  return arrangement;
}

Arrangement arrange(const Soup& soup) {
  require_finite_positions(soup);
  const CutMesh cut = build(soup);
  const FaceTree tree(cut);
  return arrange(soup, find_self_intersections(cut, tree));
}

}  // namespace meshalyzer
