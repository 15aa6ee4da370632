#include "meshalyzer/arrangement/clusters.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/exact/exact_point.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace meshalyzer {
namespace {

/// Among fewer segments equal ones are not looked for.
constexpr std::size_t kManySegments = 32;
constexpr std::size_t kClustersAtOnce = 64;
constexpr std::size_t kLookUpsAtOnce = 1024;

/// Tells whether the triangles of a pair of this kind overlap in an area.
bool overlap(ContactKind kind) {
  return kind == ContactKind::Duplicate || kind == ContactKind::FoldOver ||
         kind == ContactKind::CoplanarOverlap;
}

DisjointSets overlapping(std::span<const FaceSimplex> simplices,
                         std::span<const IntersectingPair> pairs) {
  DisjointSets sets(simplices.size());
  for (const IntersectingPair& pair : pairs) {
    if (!overlap(pair.kind)) continue;
    const Index a = simplex_number(simplices, pair.face_a);
    const Index b = simplex_number(simplices, pair.face_b);
    if (simplices[a].is_triangle() && simplices[b].is_triangle()) sets.unite(a, b);
  }
  return sets;
}

/// Returns for each point of a cluster the same rank as for all points at its position.
std::vector<Index> ranks_of(const FaceCluster& cluster, const NamedPoints& points) {
  const auto compare = [&](Index a, Index b) {
    return compare_lexicographically(points[cluster.points[a]], points[cluster.points[b]]);
  };
  std::vector<Index> order(cluster.points.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return compare(a, b) < 0; });
  std::vector<Index> ranks(order.size(), 0);
  for (std::size_t i = 1; i < order.size(); ++i) {
    ranks[order[i]] = ranks[order[i - 1]] + (compare(order[i - 1], order[i]) == 0 ? 0 : 1);
  }
  return ranks;
}

/// Keeps the first of equal segments, so that the order of the others stays, and none whose ends
/// are at one place. Those on edges are told from others, as no crossings are sought on them.
void drop_repeated_segments(FaceCluster& cluster, const NamedPoints& points) {
  if (cluster.segments.size() < kManySegments) return;
  const std::vector<Index> ranks = ranks_of(cluster, points);
  const auto rank_of = [&](Index point) {
    const auto found = std::lower_bound(cluster.points.begin(), cluster.points.end(), point);
    return ranks[static_cast<std::size_t>(found - cluster.points.begin())];
  };
  // The ranks of the ends, whether it is on an edge, and the number of a segment.
  std::vector<std::array<Index, 4>> keys;
  keys.reserve(cluster.segments.size());
  for (std::size_t i = 0; i < cluster.segments.size(); ++i) {
    const ClusterSegment& s = cluster.segments[i];
    const auto [low, high] = std::minmax({rank_of(s.from), rank_of(s.to)});
    if (low == high) continue;
    const Index is_on_edge = s.line == SegmentLine::Edge ? 1 : 0;
    keys.push_back({low, high, is_on_edge, static_cast<Index>(i)});
  }
  std::sort(keys.begin(), keys.end());
  const auto repeated = std::unique(keys.begin(), keys.end(), [](const auto& a, const auto& b) {
    return std::equal(a.begin(), a.end() - 1, b.begin());
  });
  keys.erase(repeated, keys.end());
  std::sort(keys.begin(), keys.end(),
            [](const auto& a, const auto& b) { return a.back() < b.back(); });
  std::vector<ClusterSegment> kept;
  kept.reserve(keys.size());
  for (const auto& key : keys) kept.push_back(cluster.segments[key.back()]);
  cluster.segments = std::move(kept);
}

/// Adds points and segments of contacts to the clusters of their faces.
///
/// @param cluster_of  #simplices: the cluster of each; kNoIndex where it is no triangle.
void add_contacts(std::span<const FaceSimplex> simplices, const FaceContacts& contacts,
                  const NamedPoints& points, std::span<const Index> cluster_of,
                  std::vector<FaceCluster>& clusters) {
  const auto cluster_of_face = [&](Index face) {
    return cluster_of[simplex_number(simplices, face)];
  };
  // The look-ups take nearly all the time.
  std::vector<std::pair<Index, Index>> numbers(contacts.points.size());
  parallel_chunks(numbers.size(), kLookUpsAtOnce, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const auto& [face, point] = contacts.points[i];
      numbers[i] = {cluster_of_face(face), points.find(point)};
    }
  });
  for (const auto& [cluster, point] : numbers) {
    if (cluster != kNoIndex) clusters[cluster].points.push_back(point);
  }
  std::vector<std::pair<Index, ClusterSegment>> segments(contacts.segments.size());
  parallel_chunks(segments.size(), kLookUpsAtOnce, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const ContactSegment& s = contacts.segments[i];
      segments[i] = {cluster_of_face(s.face),
                     {points.find(s.from), points.find(s.to), s.line, s.face, s.other}};
    }
  });
  for (const auto& [cluster, segment] : segments) clusters[cluster].segments.push_back(segment);
}

}  // namespace

std::vector<FaceSimplex> simplices_of(const Soup& soup, std::span<const IntersectingPair> pairs) {
  std::vector<Index> faces;
  faces.reserve(2 * pairs.size());
  for (const IntersectingPair& pair : pairs) {
    faces.insert(faces.end(), {pair.face_a, pair.face_b});
  }
  sort_unique(faces);
  std::vector<FaceSimplex> simplices(faces.size());
  parallel_chunks(faces.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      simplices[i] = face_simplex(soup, faces[i]);
    }
  });
  return simplices;
}

Index simplex_number(std::span<const FaceSimplex> simplices, Index face) {
  const auto found =
      std::lower_bound(simplices.begin(), simplices.end(), face,
                       [](const FaceSimplex& simplex, Index f) { return simplex.face < f; });
  return static_cast<Index>(found - simplices.begin());
}

std::vector<FaceCluster> make_clusters(std::span<const FaceSimplex> simplices,
                                       std::span<const IntersectingPair> pairs,
                                       const FaceContacts& contacts, const NamedPoints& points) {
  DisjointSets sets = overlapping(simplices, pairs);
  std::vector<FaceCluster> clusters;
  std::vector<Index> cluster_of(simplices.size(), kNoIndex);
  for (Index i = 0; i < simplices.size(); ++i) {
    if (!simplices[i].is_triangle()) continue;
    const Index first = sets.find(i);
    if (first == i) {
      cluster_of[i] = static_cast<Index>(clusters.size());
      clusters.push_back({.axis = simplices[i].axis, .faces = {}, .points = {}, .segments = {}});
    }
    cluster_of[i] = cluster_of[first];
    FaceCluster& cluster = clusters[cluster_of[i]];
    cluster.faces.push_back(i);
    for (const Index v : simplices[i].vertices) {
      cluster.points.push_back(points.find(vertex_name(v)));
    }
  }
  add_contacts(simplices, contacts, points, cluster_of, clusters);
  parallel_chunks(clusters.size(), kClustersAtOnce, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      sort_unique(clusters[i].points);
      drop_repeated_segments(clusters[i], points);
    }
  });
  return clusters;
}

}  // namespace meshalyzer
