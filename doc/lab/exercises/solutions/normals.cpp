#include "normals.h"

#include <cmath>

namespace lab {
namespace {

Vec3 unit_or_zero(const Vec3& v) {
  return v.norm() > 0.0 ? Vec3(v / v.norm()) : Vec3::Zero();
}

Vec3 side(const TriMesh& mesh, meshalyzer::HalfedgeHandle h) {
  return mesh.point(mesh.to_vertex_handle(h)) - mesh.point(mesh.from_vertex_handle(h));
}

}  // namespace

Vec3 face_normal(const TriMesh& mesh, FaceHandle face) {
  const meshalyzer::HalfedgeHandle h = mesh.halfedge_handle(face);
  return unit_or_zero(side(mesh, h).cross(side(mesh, mesh.next_halfedge_handle(h))));
}

Vec3 vertex_normal(const TriMesh& mesh, VertexHandle vertex) {
  Vec3 sum = Vec3::Zero();
  for (const FaceHandle f : mesh.vf_range(vertex)) sum += face_normal(mesh, f);
  return unit_or_zero(sum);
}

Vec3 angle_weighted_normal(const TriMesh& mesh, VertexHandle vertex) {
  Vec3 sum = Vec3::Zero();
  for (const meshalyzer::HalfedgeHandle h : mesh.voh_range(vertex)) {
    if (mesh.is_boundary(h)) continue;
    const Vec3 a = side(mesh, h);
    const Vec3 b = -side(mesh, mesh.prev_halfedge_handle(h));
    sum += std::atan2(a.cross(b).norm(), a.dot(b)) * face_normal(mesh, mesh.face_handle(h));
  }
  return unit_or_zero(sum);
}

}  // namespace lab
