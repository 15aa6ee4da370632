#pragma once

#include "meshalyzer/arrangement/face_simplex.h"

#include <vector>

namespace meshalyzer {

/// Names the kind of line on which a contact segment lies.
enum class SegmentLine : std::uint8_t {
  /// The line where the plane of the face meets the plane of the other.
  Plane,
  /// The other face itself, which is a segment in the plane of the face.
  Face,
  /// An edge of the face or of one that overlaps it in its plane.
  Edge,
};

/// A segment in the plane of a face that another face has in common with it. Its ends may be the
/// same place.
struct ContactSegment {
  Index face = kNoIndex;
  Index other = kNoIndex;
  SegmentLine line = SegmentLine::Plane;
  PointName from;
  PointName to;
};

/// A point of another face that lies in a face, on its border included.
struct ContactPoint {
  Index face = kNoIndex;
  PointName point;
};

/// The places where faces meet, as each face sees them: segments for the triangles, points for all.
struct FaceContacts {
  std::vector<ContactPoint> points;
  std::vector<ContactSegment> segments;
};

/// Finds where two faces meet, what they have in common by id included.
///
/// Points are the corners of one face that lie in the other, where an edge of one goes through the
/// other, and where edges in one plane cross: together the corners of the faces' intersection.
/// Decided by signs of orientations alone.
void find_face_contact(const Soup& soup, const FaceSimplex& p, const FaceSimplex& q,
                       FaceContacts& found);

}  // namespace meshalyzer
