#include "area_volume.h"

#include <array>

namespace lab {
namespace {

std::array<Vec3, 3> corners(const TriMesh& mesh, FaceHandle face) {
  const meshalyzer::HalfedgeHandle h = mesh.halfedge_handle(face);
  return {mesh.point(mesh.from_vertex_handle(h)), mesh.point(mesh.to_vertex_handle(h)),
          mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)))};
}

/// Normal to the face, of twice its area's length.
Vec3 double_area_normal(const std::array<Vec3, 3>& p) {
  return (p[1] - p[0]).cross(p[2] - p[0]);
}

bool is_closed(const TriMesh& mesh) {
  for (const meshalyzer::EdgeHandle e : mesh.edges()) {
    if (mesh.is_boundary(e)) return false;
  }
  return true;
}

}  // namespace

double face_area(const TriMesh& mesh, FaceHandle face) {
  return double_area_normal(corners(mesh, face)).norm() / 2.0;
}

double surface_area(const TriMesh& mesh) {
  double sum = 0.0;
  for (const FaceHandle f : mesh.faces()) sum += face_area(mesh, f);
  return sum;
}

std::optional<double> volume(const TriMesh& mesh) {
  if (!is_closed(mesh)) return std::nullopt;
  double flow = 0.0;
  for (const FaceHandle f : mesh.faces()) {
    const std::array<Vec3, 3> p = corners(mesh, f);
    // Unit normal times area is half of the cross product: no division, so no zero to divide by.
    flow += ((p[0] + p[1] + p[2]) / 3.0).dot(double_area_normal(p) / 2.0);
  }
  return flow / 3.0;
}

}  // namespace lab
