#pragma once

#include "meshalyzer/arrangement/face_contact.h"
#include "meshalyzer/arrangement/named_points.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// A ContactSegment in a cluster, its ends by their numbers.
struct ClusterSegment {
  Index from = kNoIndex;
  Index to = kNoIndex;
  SegmentLine line = SegmentLine::Plane;
  /// The face of the cluster that the segment is in, and the other one, both by file index.
  Index face = kNoIndex;
  Index other = kNoIndex;
};

/// Triangles that are cut together: one that overlaps no other in its plane, or all that do,
/// directly or through others.
struct FaceCluster {
  /// An axis along which the plane projects to an area.
  Axis axis = Axis::X;
  /// The faces by the numbers of their simplices, ascending.
  std::vector<Index> faces;
  /// Numbers of the points that lie in the faces, their corners included. Ascending, each once.
  std::vector<Index> points;
  std::vector<ClusterSegment> segments;
};

/// Returns the simplices of the faces of these pairs, ascending by face.
[[nodiscard]] std::vector<FaceSimplex> simplices_of(const Soup& soup,
                                                    std::span<const IntersectingPair> pairs);

/// Returns the number of the simplex of a face, which must have one.
[[nodiscard]] Index simplex_number(std::span<const FaceSimplex> simplices, Index face);

/// Groups the triangles among the faces, with all that lies in them.
///
/// @param points  Holds the corners of all simplices, and all that the contacts name.
/// @return        Ascending by first face.
[[nodiscard]] std::vector<FaceCluster> make_clusters(std::span<const FaceSimplex> simplices,
                                                     std::span<const IntersectingPair> pairs,
                                                     const FaceContacts& contacts,
                                                     const NamedPoints& points);

}  // namespace meshalyzer
