#pragma once

#include "meshalyzer/arrangement/face_contact.h"
#include "meshalyzer/arrangement/named_points.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// A ContactSegment in a cluster; its ends are given by their numbers.
struct ClusterSegment {
  Index from = kNoIndex;
  Index to = kNoIndex;
  SegmentLine line = SegmentLine::Plane;
  /// The face of the cluster that contains the segment, and the other one, by file index.
  Index face = kNoIndex;
  Index other = kNoIndex;
};

/// Triangles that are cut together: a single one, or those that overlap in their plane, directly or
/// through others.
struct FaceCluster {
  /// An axis along which the plane projects to non-zero area.
  Axis axis = Axis::X;
  /// The numbers of the simplices of the faces, ascending.
  std::vector<Index> faces;
  /// The numbers of the points in the faces, including their corners, ascending, each once.
  std::vector<Index> points;
  /// The segments in the faces. Where they are many, each is there once by the positions of its
  /// ends, which differ: hundreds of faces on each other have thousands of equal ones.
  std::vector<ClusterSegment> segments;
};

/// Returns the simplices of the faces of these pairs, ascending by face.
[[nodiscard]] std::vector<FaceSimplex> simplices_of(const Soup& soup,
                                                    std::span<const IntersectingPair> pairs);

/// Returns the number of the simplex of a face, which must have one.
[[nodiscard]] Index simplex_number(std::span<const FaceSimplex> simplices, Index face);

/// Groups the triangles among the faces to clusters, with the points and segments in them.
///
/// @param points  The points, with the corners of all simplices and all points of the contacts.
/// @return        The clusters, ascending by first face.
[[nodiscard]] std::vector<FaceCluster> make_clusters(std::span<const FaceSimplex> simplices,
                                                     std::span<const IntersectingPair> pairs,
                                                     const FaceContacts& contacts,
                                                     const NamedPoints& points);

}  // namespace meshalyzer
