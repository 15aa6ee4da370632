#include "meshalyzer/repair/holes/internal/rim_bend.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/geometry/face_measures.h"
#include "meshalyzer/repair/holes/internal/patch_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace meshalyzer {
namespace {

/// A hole is flat if the mean angle between patch and surface is smaller, and no larger one is
/// expected.
constexpr double kFlatRim = std::numbers::pi / 180.0;
/// Faces with a larger angle between them than 50 degrees meet at a crease.
constexpr double kCosineOfCrease = 0.643;
/// The fraction of the bend that the surface must account for.
constexpr double kExplainedShare = 1.0 / 3.0;

/// An edge of a hole, with the face beyond it and the face of the patch.
struct RimEdge {
  FaceHandle beyond;
  double length = 0.0;
  Vec3 normal_beyond = Vec3::Zero();
  /// The unit vector in the plane of the face beyond, across the edge and into the hole.
  Vec3 inward = Vec3::Zero();
  Vec3 normal_of_patch = Vec3::Zero();

  /// Returns the angle by which the patch is bent, positive where it is convex.
  [[nodiscard]] double bend() const {
    return std::atan2(normal_of_patch.dot(inward), normal_of_patch.dot(normal_beyond));
  }
};

/// Returns the edges of a hole that are no bridges and have faces with an area on both sides.
std::vector<RimEdge> rim_edges(const PreparedMesh& mesh, const HoleLoop& loop, const Patch& patch) {
  const CutMesh& cut = mesh.cut();
  const Soup& soup = mesh.soup();
  const PatchEdges edges(patch);
  std::vector<RimEdge> rim;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Index face = edges.face_at({loop.vertices[i], loop.next(i)});
    if (!loop.halfedges[i].is_valid() || face == kNoIndex) continue;
    RimEdge edge{.beyond = cut.mesh.face_handle(loop.halfedges[i])};
    const Vec3 along = soup.positions[loop.next(i)] - soup.positions[loop.vertices[i]];
    edge.length = along.stableNorm();
    edge.normal_beyond = normal_of(face_corners(cut.mesh, edge.beyond)).stableNormalized();
    edge.normal_of_patch =
        normal_of(corners_of(soup, patch, patch.triangles[face])).stableNormalized();
    edge.inward = edge.normal_beyond.cross(along).stableNormalized();
    if (!edge.inward.isZero(0.0) && !edge.normal_of_patch.isZero(0.0)) rim.push_back(edge);
  }
  return rim;
}

/// Returns the curvature of the surface beyond an edge in the direction across it: the value that
/// fits the turns of the normals of the faces round the one beyond best. Faces beyond a crease do
/// not count.
double curvature_across(const TriMesh& mesh, const RimEdge& edge) {
  const Vec3 middle = centroid_of(face_corners(mesh, edge.beyond));
  double products = 0.0;
  double squares = 0.0;
  for (const VertexHandle v : mesh.fv_range(edge.beyond)) {
    for (const FaceHandle f : mesh.vf_range(v)) {
      const Corners corners = face_corners(mesh, f);
      const Vec3 normal = normal_of(corners).stableNormalized();
      if (normal.dot(edge.normal_beyond) < kCosineOfCrease) continue;
      const double distance = (middle - centroid_of(corners)).dot(edge.inward);
      products += distance * (edge.normal_beyond - normal).dot(edge.inward);
      squares += distance * distance;
    }
  }
  return squares > 0.0 ? products / squares : 0.0;
}

double area_of(const Soup& soup, const Patch& patch) {
  double area = 0.0;
  for (const Triangle& t : patch.triangles) {
    area += 0.5 * normal_of(corners_of(soup, patch, t)).stableNorm();
  }
  return area;
}

/// The angles at the edges of a hole times the edges' lengths, added up, and the lengths.
struct RimBend {
  double total = 0.0;
  double length = 0.0;
};

RimBend measure_rim_bend(const PreparedMesh& mesh, const HoleLoop& loop, const Patch& patch) {
  RimBend result;
  for (const RimEdge& edge : rim_edges(mesh, loop, patch)) {
    result.total += edge.length * std::abs(edge.bend());
    result.length += edge.length;
  }
  return result;
}

}  // namespace

double mean_rim_bend(const PreparedMesh& mesh, const HoleLoop& loop, const Patch& patch) {
  const RimBend bend = measure_rim_bend(mesh, loop, patch);
  return bend.length > 0.0 ? bend.total / bend.length : 0.0;
}

double total_rim_bend(const PreparedMesh& mesh, const HoleLoop& loop, const Patch& patch) {
  return measure_rim_bend(mesh, loop, patch).total;
}

bool bends_into_hole(const PreparedMesh& mesh, const HoleLoop& loop, const Patch& patch) {
  // The radius of a round hole of this length.
  const double to_middle = 2.0 * area_of(mesh.soup(), patch) / length_of(mesh.soup(), loop);
  double bends = 0.0;
  double expected = 0.0;
  double length = 0.0;
  for (const RimEdge& edge : rim_edges(mesh, loop, patch)) {
    const double turn = std::abs(curvature_across(mesh.cut().mesh, edge)) * to_middle;
    bends += edge.length * std::abs(edge.bend());
    expected += edge.length * std::min(turn, std::numbers::pi);
    length += edge.length;
  }
  return std::max(bends, expected) > kFlatRim * length && expected > kExplainedShare * bends;
}

}  // namespace meshalyzer
