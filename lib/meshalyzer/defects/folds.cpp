#include "meshalyzer/defects/folds.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/geometry/edge_measures.h"

#include <algorithm>

namespace meshalyzer {
namespace {

/// The ends of an edge, and the third corners of the face of the half-edge and of the other one.
struct EdgePlaces {
  const Vec3& a;
  const Vec3& b;
  const Vec3& c;
  const Vec3& d;
};

EdgePlaces places_of(const TriMesh& mesh, HalfedgeHandle h) {
  const HalfedgeHandle opposite = mesh.opposite_halfedge_handle(h);
  return {mesh.point(mesh.from_vertex_handle(h)), mesh.point(mesh.to_vertex_handle(h)),
          mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h))),
          mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(opposite)))};
}

/// Whether the angle between the faces is above 90 degrees for sure: their normals are at less than
/// 90 degrees. The products are off by some 2^-50 of the lengths that are multiplied; what is too
/// long or short to be squared is sure of nothing.
bool is_surely_blunt(const EdgePlaces& p) {
  const Vec3 edge = p.b - p.a;
  const Vec3 u = p.c - p.a;
  const Vec3 v = p.d - p.a;
  const double dot = edge.cross(u).dot(v.cross(edge));
  const double size = edge.squaredNorm();
  return dot > 0.0 && dot * dot > 1e-24 * size * size * u.squaredNorm() * v.squaredNorm() &&
         size > 1e-60;
}

bool is_fold(const TriMesh& mesh, HalfedgeHandle h, double max_angle) {
  const EdgePlaces p = places_of(mesh, h);
  if (max_angle < 90.0 && is_surely_blunt(p)) return false;
  if (are_collinear(p.a, p.b, p.c) || are_collinear(p.a, p.b, p.d)) return false;
  const double angle = edge_angle_degrees(mesh, h);
  return std::min(angle, 360.0 - angle) <= max_angle;
}

}  // namespace

std::vector<HalfedgeHandle> find_folds(const TriMesh& mesh, double max_angle) {
  const auto found = map_chunks<std::vector<HalfedgeHandle>>(mesh.n_edges(), [&](Chunk chunk) {
    std::vector<HalfedgeHandle> folds;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const EdgeHandle e(static_cast<int>(i));
      if (mesh.is_boundary(e)) continue;
      const HalfedgeHandle h = mesh.halfedge_handle(e, 0);
      if (is_fold(mesh, h, max_angle)) folds.push_back(h);
    }
    return folds;
  });
  std::vector<HalfedgeHandle> folds;
  for (const auto& part : found) folds.insert(folds.end(), part.begin(), part.end());
  return folds;
}

}  // namespace meshalyzer
