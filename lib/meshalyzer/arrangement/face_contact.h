#pragma once

#include "meshalyzer/arrangement/face_simplex.h"

#include <vector>

namespace meshalyzer {

/// The kind of line on which a contact segment lies.
enum class SegmentLine : std::uint8_t {
  /// The line where the plane of the face meets the plane of the other.
  Plane,
  /// The other face itself, which is a segment in the plane of the face.
  Face,
  /// An edge of the face, or of a coplanar face that overlaps it.
  Edge,
};

/// A segment that a face shares with another one. Its ends may coincide.
struct ContactSegment {
  Index face = kNoIndex;
  Index other = kNoIndex;
  SegmentLine line = SegmentLine::Plane;
  PointName from;
  PointName to;
};

/// A point of another face that lies in a face or on its border.
struct ContactPoint {
  Index face = kNoIndex;
  PointName point;
};

/// The contacts of faces, from the viewpoint of each face: segments for the triangles, points for
/// all.
struct FaceContacts {
  std::vector<ContactPoint> points;
  std::vector<ContactSegment> segments;
};

/// Finds where two faces meet, including what they have in common by id.
///
/// The points are the corners of one face that lie in the other, the points where an edge of one
/// passes through the other, and the crossings of coplanar edges: together they are the corners of
/// the faces' intersection. Only signs of orientations decide.
void find_face_contact(const Soup& soup, const FaceSimplex& p, const FaceSimplex& q,
                       FaceContacts& found);

}  // namespace meshalyzer
