#include "curvature.h"

#include <cmath>
#include <numbers>

namespace lab {
namespace {

/// A face round a vertex, as seen from it.
struct Corner {
  /// The sides from the vertex to the other two corners, counter-clockwise.
  Vec3 a;
  Vec3 b;

  [[nodiscard]] Vec3 double_area_normal() const { return a.cross(b); }
  [[nodiscard]] double double_area() const { return double_area_normal().norm(); }
  [[nodiscard]] double angle() const { return std::atan2(double_area(), a.dot(b)); }
  /// The cotangents of the angles at the other ends of a and b.
  [[nodiscard]] double cot_at_a() const { return -a.dot(b - a) / double_area(); }
  [[nodiscard]] double cot_at_b() const { return b.dot(b - a) / double_area(); }
};

template <typename Function>
void for_each_corner(const TriMesh& mesh, VertexHandle vertex, Function visit) {
  const Vec3 centre = mesh.point(vertex);
  for (const meshalyzer::HalfedgeHandle h : mesh.voh_range(vertex)) {
    if (mesh.is_boundary(h)) continue;
    const meshalyzer::HalfedgeHandle next = mesh.next_halfedge_handle(h);
    visit(Corner{mesh.point(mesh.to_vertex_handle(h)) - centre,
                 mesh.point(mesh.to_vertex_handle(next)) - centre});
  }
}

bool has_curvature(const TriMesh& mesh, VertexHandle vertex) {
  return !mesh.is_isolated(vertex) && !mesh.is_boundary(vertex) && voronoi_area(mesh, vertex) > 0.0;
}

}  // namespace

double angle_defect(const TriMesh& mesh, VertexHandle vertex) {
  double defect = 2.0 * std::numbers::pi;
  for_each_corner(mesh, vertex, [&](const Corner& c) { defect -= c.angle(); });
  return defect;
}

double one_ring_area(const TriMesh& mesh, VertexHandle vertex) {
  double area = 0.0;
  for_each_corner(mesh, vertex, [&](const Corner& c) { area += c.double_area() / 2.0; });
  return area;
}

double voronoi_area(const TriMesh& mesh, VertexHandle vertex) {
  double area = 0.0;
  for_each_corner(mesh, vertex, [&](const Corner& c) {
    // In each face the angle opposite to side a is that at the end of b.
    area += (c.cot_at_b() * c.a.squaredNorm() + c.cot_at_a() * c.b.squaredNorm()) / 8.0;
  });
  return area;
}

std::optional<double> gaussian_curvature(const TriMesh& mesh, VertexHandle vertex) {
  if (!has_curvature(mesh, vertex)) return std::nullopt;
  return angle_defect(mesh, vertex) / voronoi_area(mesh, vertex);
}

Vec3 cotangent_vector(const TriMesh& mesh, VertexHandle vertex) {
  Vec3 sum = Vec3::Zero();
  for_each_corner(mesh, vertex,
                  [&](const Corner& c) { sum -= c.cot_at_b() * c.a + c.cot_at_a() * c.b; });
  return sum;
}

std::optional<double> mean_curvature(const TriMesh& mesh, VertexHandle vertex) {
  if (!has_curvature(mesh, vertex)) return std::nullopt;
  Vec3 normal = Vec3::Zero();
  for_each_corner(mesh, vertex, [&](const Corner& c) {
    const double twice = c.double_area();
    if (twice > 0.0) normal += c.angle() * c.double_area_normal() / twice;
  });
  const Vec3 vector = cotangent_vector(mesh, vertex);
  return std::copysign(vector.norm(), vector.dot(normal)) / (4.0 * voronoi_area(mesh, vertex));
}

}  // namespace lab
