#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// Returns the lengths of all edges of a mesh, in the mesh's unit, indexed by EdgeHandle::idx().
///
/// @complexity O(#E).
[[nodiscard]] std::vector<double> mesh_edge_lengths(const TriMesh& mesh);

/// Returns the lengths of some edges, in the same order.
///
/// @param edges    One half-edge of each edge, see complex_edges().
/// @param lengths  The result of mesh_edge_lengths().
[[nodiscard]] std::vector<double> lengths_of(std::span<const HalfedgeHandle> edges,
                                             std::span<const double> lengths);

/// The angles at the edges that have two consistently oriented faces of non-zero area.
struct EdgeAngles {
  /// One half-edge of each edge that has an angle, in order of the mesh's edges.
  std::vector<HalfedgeHandle> edges;
  /// The angle at each of these edges, see edge_angle_degrees().
  std::vector<double> degrees;
};

/// Returns the angle between two directions, 0 ... 180 degrees, accurately at both ends of the
/// range.
[[nodiscard]] double angle_between_degrees(const Vec3& a, const Vec3& b);

/// Returns the angle at the edge of a half-edge, from its face round to the other one, on the side
/// that their normals point to. It is 0 ... 360 degrees: 180 where the faces are flat, 270 at the
/// edges of an outward cube, 90 where two walls meet ("edge angle" in doc/definitions.md).
///
/// Which side of 180 degrees the angle is on is decided exactly. Coplanar faces give exactly 180,
/// or 0 if they are folded onto each other.
///
/// @param halfedge  A half-edge that has a face of non-zero area, as does its opposite.
[[nodiscard]] double edge_angle_degrees(const TriMesh& mesh, HalfedgeHandle halfedge);

/// Measures the angles at all edges that have one.
///
/// @param zero_area  The mesh's faces of zero area, ascending; their edges have no angle.
/// @complexity       O(#E).
[[nodiscard]] EdgeAngles measure_edge_angles(const TriMesh& mesh,
                                             std::span<const FaceHandle> zero_area);

}  // namespace meshalyzer
