#include "shapes.h"

#include <cmath>
#include <numbers>

namespace lab::shapes {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

TriMesh make(const std::vector<Vec3>& points, const Faces& faces) {
  TriMesh mesh;
  for (const Vec3& p : points) mesh.add_vertex(p);
  for (const auto& [a, b, c] : faces) {
    mesh.add_face(mesh.vertex_handle(static_cast<unsigned>(a)),
                  mesh.vertex_handle(static_cast<unsigned>(b)),
                  mesh.vertex_handle(static_cast<unsigned>(c)));
  }
  return mesh;
}

/// A quadrilateral a b c d as two triangles.
void add_quad(Faces& faces, const std::array<int, 4>& q) {
  faces.push_back({q[0], q[1], q[2]});
  faces.push_back({q[0], q[2], q[3]});
}

std::vector<Vec3> octahedron_points() {
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
}

}  // namespace

Faces tetrahedron_faces() {
  return {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
}

TriMesh tetrahedron() {
  return make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, tetrahedron_faces());
}

TriMesh cube() {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) {
    points.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  }
  Faces faces;
  add_quad(faces, {0, 2, 3, 1});
  add_quad(faces, {4, 5, 7, 6});
  add_quad(faces, {0, 1, 5, 4});
  add_quad(faces, {2, 6, 7, 3});
  add_quad(faces, {0, 4, 6, 2});
  add_quad(faces, {1, 3, 7, 5});
  return make(points, faces);
}

Faces octahedron_faces() {
  return {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}, {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}};
}

TriMesh octahedron() {
  return make(octahedron_points(), octahedron_faces());
}

TriMesh open_octahedron() {
  Faces faces = octahedron_faces();
  faces.erase(faces.begin());
  return make(octahedron_points(), faces);
}

TriMesh sphere(int n) {
  std::vector<Vec3> points;
  for (int ring = 1; ring < n; ++ring) {
    const double polar = kTurn / 2.0 * ring / n;
    for (int i = 0; i < n; ++i) {
      const double azimuth = kTurn * i / n;
      points.emplace_back(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                          std::cos(polar));
    }
  }
  const int top = static_cast<int>(points.size());
  points.emplace_back(0, 0, 1);
  points.emplace_back(0, 0, -1);
  Faces faces;
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    const int last = (n - 2) * n;
    faces.push_back({top, i, j});
    for (int ring = 0; ring + 2 < n; ++ring) {
      const int upper = ring * n;
      add_quad(faces, {upper + i, upper + n + i, upper + n + j, upper + j});
    }
    faces.push_back({top + 1, last + j, last + i});
  }
  return make(points, faces);
}

TriMesh torus(int n) {
  std::vector<Vec3> points;
  Faces faces;
  for (int i = 0; i < n; ++i) {
    const double u = kTurn * i / n;
    for (int j = 0; j < n; ++j) {
      const double v = kTurn * j / n;
      const double r = 2.0 + std::cos(v);
      points.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
      const int next_i = (i + 1) % n;
      const int next_j = (j + 1) % n;
      add_quad(faces, {i * n + j, next_i * n + j, next_i * n + next_j, i * n + next_j});
    }
  }
  return make(points, faces);
}

TriMesh square() {
  return make({{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}},
              {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
}

TriMesh star() {
  std::vector<Vec3> points{{0, 0, 0}};
  Faces faces;
  for (int i = 0; i < 6; ++i) {
    const double angle = kTurn * i / 6;
    points.push_back((i % 2 == 0 ? 0.1 : 1.0) * Vec3(std::cos(angle), std::sin(angle), 0.0));
    faces.push_back({0, 1 + i, 1 + (i + 1) % 6});
  }
  return make(points, faces);
}

TriMesh annulus(int n) {
  std::vector<Vec3> points;
  Faces faces;
  for (int i = 0; i < n; ++i) {
    const double angle = kTurn * i / n;
    const Vec3 outward(std::cos(angle), std::sin(angle), 0.0);
    points.push_back(outward);
    points.emplace_back(2.0 * outward);
    const int j = (i + 1) % n;
    add_quad(faces, {2 * i, 2 * i + 1, 2 * j + 1, 2 * j});
  }
  return make(points, faces);
}

TriMesh double_pyramid(double z) {
  return make(
      {{0, 0, z}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}});
}

TriMesh turned_inside_out(const TriMesh& mesh) {
  std::vector<Vec3> points;
  for (const auto v : mesh.vertices()) points.push_back(mesh.point(v));
  Faces faces;
  for (const auto f : mesh.faces()) {
    std::array<int, 3> corners{};
    std::size_t k = 3;
    for (const auto v : mesh.fv_range(f)) corners[--k] = v.idx();
    faces.push_back(corners);
  }
  return make(points, faces);
}

TriMesh moved(TriMesh mesh, const Vec3& by) {
  for (const auto v : mesh.vertices()) mesh.set_point(v, mesh.point(v) + by);
  return mesh;
}

TriMesh together(TriMesh mesh, const TriMesh& other) {
  const int shift = static_cast<int>(mesh.n_vertices());
  for (const auto v : other.vertices()) mesh.add_vertex(other.point(v));
  for (const auto f : other.faces()) {
    std::vector<meshalyzer::VertexHandle> corners;
    for (const auto v : other.fv_range(f)) corners.emplace_back(v.idx() + shift);
    mesh.add_face(corners);
  }
  return mesh;
}

TriMesh with_orphan(TriMesh mesh) {
  mesh.add_vertex(Vec3(0.5, 0.5, 0.5));
  return mesh;
}

}  // namespace lab::shapes
