#include "meshalyzer/arrangement/clusters.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"

#include <algorithm>

namespace meshalyzer {
namespace {

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
  for (const auto& [face, point] : contacts.points) {
    const Index cluster = cluster_of[simplex_number(simplices, face)];
    if (cluster != kNoIndex) clusters[cluster].points.push_back(points.find(point));
  }
  for (const ContactSegment& s : contacts.segments) {
    clusters[cluster_of[simplex_number(simplices, s.face)]].segments.push_back(
        {points.find(s.from), points.find(s.to), s.line, s.face, s.other});
  }
  for (FaceCluster& cluster : clusters) {
    sort_unique(cluster.points);
  }
  return clusters;
}

}  // namespace meshalyzer
