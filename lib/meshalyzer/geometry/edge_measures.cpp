#include "meshalyzer/geometry/edge_measures.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/exact/predicates.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace meshalyzer {
namespace {

/// Tells whether c and d, which lie in the plane of a and b, are on different sides of the line a
/// b.
bool on_different_sides(const Corners& abc, const Vec3& d) {
  const Axis axis = *projection_axis(abc[0], abc[1], abc[2]);
  return orient2d(axis, abc[0], abc[1], abc[2]) * orient2d(axis, abc[0], abc[1], d) < 0;
}

bool has_angle(const TriMesh& mesh, EdgeHandle e, std::span<const std::uint8_t> is_thin) {
  if (mesh.is_boundary(e)) {
    return false;
  }
  const auto thin = [&](unsigned side) {
    return is_thin[static_cast<std::size_t>(
               mesh.face_handle(mesh.halfedge_handle(e, side)).idx())] != 0;
  };
  return is_thin.empty() || (!thin(0) && !thin(1));
}

/// Tells whether the direction of a normal is as accurate as its computation.
bool is_accurate(const Vec3& normal) {
  return is_of_usual_scale(normal.cwiseAbs().maxCoeff());
}

/// Returns the angle between the normals of two faces of any size.
double angle_between_normals(const Corners& first, const Corners& second) {
  const Vec3 a = accurate_normal(first);
  const Vec3 b = accurate_normal(second);
  return is_accurate(a) && is_accurate(b)
             ? angle_between_degrees(a, b)
             : angle_between_degrees(rescaled_normal(first), rescaled_normal(second));
}

}  // namespace

double angle_between_degrees(const Vec3& a, const Vec3& b) {
  const Vec3 u = a.stableNormalized();
  const Vec3 v = b.stableNormalized();
  return std::atan2(u.cross(v).norm(), u.dot(v)) * (180.0 / std::numbers::pi);
}

std::vector<double> mesh_edge_lengths(const TriMesh& mesh) {
  std::vector<double> lengths(mesh.n_edges());
  parallel_chunks(lengths.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const HalfedgeHandle h = mesh.halfedge_handle(EdgeHandle(static_cast<int>(i)), 0);
      const Vec3& from = mesh.point(mesh.from_vertex_handle(h));
      const Vec3& to = mesh.point(mesh.to_vertex_handle(h));
      lengths[i] = (to - from).stableNorm();
    }
  });
  return lengths;
}

std::vector<double> lengths_of(std::span<const HalfedgeHandle> edges,
                               std::span<const double> lengths) {
  std::vector<double> chosen(edges.size());
  std::transform(edges.begin(), edges.end(), chosen.begin(),
                 [&](HalfedgeHandle h) { return lengths[static_cast<std::size_t>(h.idx()) / 2]; });
  return chosen;
}

double edge_angle_degrees(const TriMesh& mesh, HalfedgeHandle halfedge) {
  const HalfedgeHandle opposite = mesh.opposite_halfedge_handle(halfedge);
  const Vec3& a = mesh.point(mesh.from_vertex_handle(halfedge));
  const Vec3& b = mesh.point(mesh.to_vertex_handle(halfedge));
  const Vec3& c = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(halfedge)));
  const Vec3& d = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(opposite)));
  const Sign side = orient3d(a, b, c, d);
  if (side == 0) {
    return on_different_sides({a, b, c}, d) ? 180.0 : 0.0;
  }
  // The second face lies below the first at a convex edge, where the outer angle exceeds 180
  // degrees.
  return 180.0 - side * angle_between_normals({a, b, c}, {b, a, d});
}

EdgeAngles measure_edge_angles(const TriMesh& mesh, std::span<const FaceHandle> zero_area) {
  std::vector<std::uint8_t> is_thin(zero_area.empty() ? 0 : mesh.n_faces(), 0);
  for (const FaceHandle f : zero_area) {
    is_thin[static_cast<std::size_t>(f.idx())] = 1;
  }
  EdgeAngles angles;
  angles.edges = collect_chunks<HalfedgeHandle>(
      mesh.n_edges(), [&](Chunk chunk, std::vector<HalfedgeHandle>& edges) {
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
          const EdgeHandle e(static_cast<int>(i));
          if (has_angle(mesh, e, is_thin)) edges.push_back(mesh.halfedge_handle(e, 0));
        }
      });
  angles.degrees.resize(angles.edges.size());
  parallel_chunks(angles.edges.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      angles.degrees[i] = edge_angle_degrees(mesh, angles.edges[i]);
    }
  });
  return angles;
}

}  // namespace meshalyzer
