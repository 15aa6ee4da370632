#include "meshalyzer/arrangement/clusters.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"

#include <algorithm>

namespace meshalyzer {
namespace {

/// Whether triangles of a pair of this kind share an area.
bool overlap(ContactKind kind) {
  return kind == ContactKind::Duplicate || kind == ContactKind::FoldOver ||
         kind == ContactKind::CoplanarOverlap;
}

DisjointSets overlapping(std::span<const FaceShape> shapes,
                         std::span<const IntersectingPair> pairs) {
  DisjointSets sets(shapes.size());
  for (const IntersectingPair& pair : pairs) {
    if (!overlap(pair.kind)) continue;
    const Index a = shape_number(shapes, pair.face_a);
    const Index b = shape_number(shapes, pair.face_b);
    if (shapes[a].is_triangle() && shapes[b].is_triangle()) sets.unite(a, b);
  }
  return sets;
}

}  // namespace

std::vector<FaceShape> shapes_of(const Soup& soup, std::span<const IntersectingPair> pairs) {
  std::vector<Index> faces;
  faces.reserve(2 * pairs.size());
  for (const IntersectingPair& pair : pairs) {
    faces.insert(faces.end(), {pair.face_a, pair.face_b});
  }
  sort_unique(faces);
  std::vector<FaceShape> shapes(faces.size());
  parallel_chunks(faces.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) shapes[i] = face_shape(soup, faces[i]);
  });
  return shapes;
}

Index shape_number(std::span<const FaceShape> shapes, Index face) {
  const auto found =
      std::lower_bound(shapes.begin(), shapes.end(), face,
                       [](const FaceShape& shape, Index f) { return shape.face < f; });
  return static_cast<Index>(found - shapes.begin());
}

std::vector<FaceCluster> make_clusters(std::span<const FaceShape> shapes,
                                       std::span<const IntersectingPair> pairs,
                                       const FaceContacts& contacts, const NamedPoints& points) {
  DisjointSets sets = overlapping(shapes, pairs);
  std::vector<FaceCluster> clusters;
  std::vector<Index> cluster_of(shapes.size(), kNoIndex);
  for (Index i = 0; i < shapes.size(); ++i) {
    if (!shapes[i].is_triangle()) continue;
    const Index first = sets.find(i);
    if (first == i) {
      cluster_of[i] = static_cast<Index>(clusters.size());
      clusters.push_back({.axis = shapes[i].axis, .faces = {}, .points = {}, .segments = {}});
    }
    cluster_of[i] = cluster_of[first];
    FaceCluster& cluster = clusters[cluster_of[i]];
    cluster.faces.push_back(i);
    for (const Index v : shapes[i].vertices) {
      cluster.points.push_back(points.find(vertex_name(v)));
    }
  }
  for (const auto& [face, point] : contacts.points) {
    const Index cluster = cluster_of[shape_number(shapes, face)];
    if (cluster != kNoIndex) clusters[cluster].points.push_back(points.find(point));
  }
  for (const ContactSegment& s : contacts.segments) {
    clusters[cluster_of[shape_number(shapes, s.face)]].segments.push_back(
        {points.find(s.from), points.find(s.to), s.line, s.face, s.other});
  }
  for (FaceCluster& cluster : clusters) {
    sort_unique(cluster.points);
  }
  return clusters;
}

}  // namespace meshalyzer
