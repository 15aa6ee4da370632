#include "support/shape_figures.h"

#include "support/shapes.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace meshalyzer {
namespace {

using std::numbers::pi;
using std::numbers::sqrt2;
using std::numbers::sqrt3;

double real(std::size_t n) {
  return static_cast<double>(n);
}

/// The area of n quads between two circles of a shape of revolution, round which there are n steps.
double band_area(std::size_t n, const Eigen::Vector2d& rz, const Eigen::Vector2d& next_rz) {
  const double a = pi / real(n);
  const double slope = std::hypot(next_rz.y() - rz.y(), std::cos(a) * (next_rz.x() - rz.x()));
  return real(n) * std::sin(a) * (rz.x() + next_rz.x()) * slope;
}

ShapeFigures uv_sphere(std::size_t n_lat, std::size_t n_lon) {
  double area = 0;
  double squares = 0;
  for (std::size_t i = 1; i <= n_lat; ++i) {
    const double polar = pi * real(i) / real(n_lat);
    const double previous = pi * real(i - 1) / real(n_lat);
    const double r = std::sin(polar);
    const double r0 = std::sin(previous);
    const double height = std::cos(previous) - std::cos(polar);
    area += band_area(n_lon, {r0, std::cos(previous)}, {r, std::cos(polar)});
    squares += height * (r * r + r * r0 + r0 * r0);
  }
  const double volume = real(n_lon) * std::sin(2 * pi / real(n_lon)) / 6 * squares;
  return {.name = "sphere",
          .soup = shapes::uv_sphere(n_lat, n_lon),
          .edges = 3 * (n_lat - 1) * n_lon,
          .area = area,
          .volume = volume};
}

ShapeFigures torus(std::size_t nu, std::size_t nv) {
  const double R = 2;
  const double r = 0.5;
  const auto at = [&](std::size_t j) {
    const double tube = 2 * pi * real(j) / real(nv);
    return Eigen::Vector2d(R + r * std::cos(tube), r * std::sin(tube));
  };
  double area = 0;
  for (std::size_t j = 1; j <= nv; ++j) area += band_area(nu, at(j - 1), at(j));
  const double volume =
      real(nu * nv) * R * r * r * std::sin(2 * pi / real(nu)) * std::sin(2 * pi / real(nv)) / 2;
  return {.name = "torus",
          .soup = shapes::torus(R, r, nu, nv),
          .edges = 3 * nu * nv,
          .genus = 1,
          .area = area,
          .volume = volume};
}

ShapeFigures icosahedron() {
  const double a = 1 / std::sin(2 * pi / 5);
  return {.name = "icosahedron",
          .soup = shapes::icosphere(0),
          .edges = 30,
          .area = 5 * sqrt3 * a * a,
          .volume = 5 * (3 + std::sqrt(5.0)) * a * a * a / 12};
}

ShapeFigures open_shape(std::string name, Soup soup, std::size_t border_edges, double area) {
  ShapeFigures figures;
  figures.name = std::move(name);
  figures.soup = std::move(soup);
  figures.boundaries = 1;
  figures.border_edges = border_edges;
  figures.outward = std::nullopt;
  figures.area = area;
  return figures;
}

ShapeFigures one_sided(std::string name, Soup soup, std::size_t edges) {
  ShapeFigures figures;
  figures.name = std::move(name);
  figures.soup = std::move(soup);
  figures.edges = edges;
  figures.orientable = figures.consistent = false;
  figures.outward = std::nullopt;
  figures.genus = std::nullopt;
  return figures;
}

ShapeFigures not_manifold(std::string name, Soup soup, std::size_t edges, double area) {
  ShapeFigures figures = one_sided(std::move(name), std::move(soup), edges);
  figures.manifold = false;
  figures.orientable = figures.consistent = std::nullopt;
  figures.area = area;
  return figures;
}

void add_solids(std::vector<ShapeFigures>& all) {
  all.push_back({.name = "tetrahedron",
                 .soup = shapes::tetrahedron(),
                 .edges = 6,
                 .area = (3 + sqrt3) / 2,
                 .volume = 1.0 / 6});
  all.push_back(
      {.name = "cube", .soup = shapes::cube(2.5), .edges = 18, .area = 37.5, .volume = 15.625});
  all.push_back(uv_sphere(8, 16));
  all.push_back(icosahedron());
  all.push_back(torus(12, 8));
  all.push_back({.name = "block with three holes",
                 .soup = shapes::genus_block(3),
                 .edges = 54 * 3 + 42,
                 .genus = 3,
                 .area = 18 * 3 + 14,
                 .volume = 5 * 3 + 3});
  all.push_back({.name = "cavity",
                 .soup = shapes::nested_cubes(shapes::InnerShell::Cavity),
                 .edges = 36,
                 .components = 2,
                 .edge_components = 2,
                 .area = 60,
                 .volume = 26});
  all.push_back({.name = "cavity inside out",
                 .soup = shapes::nested_cubes(shapes::InnerShell::Outward),
                 .edges = 36,
                 .components = 2,
                 .edge_components = 2,
                 .outward = false,
                 .area = 60,
                 .volume = 28});
  all.push_back({.name = "pillow",
                 .soup = shapes::pillow(),
                 .edges = 3,
                 .outward = std::nullopt,
                 .area = 1,
                 .volume = 0});
}

void add_open_and_one_sided(std::vector<ShapeFigures>& all) {
  all.push_back(open_shape("open cube", shapes::open_cube(), 4, 5));
  all.back().edges = 17;
  all.push_back(open_shape("grid", shapes::grid(3, 2), 10, 6));
  all.back().edges = 3 * 3 * 2 + 3 + 2;
  all.push_back(one_sided("Moebius strip", shapes::moebius_strip(16), 64));
  all.back().boundaries = 1;
  all.back().border_edges = 32;
  all.push_back(one_sided("projective plane", shapes::projective_plane(), 15));
  all.push_back(one_sided("Klein bottle", shapes::klein_bottle(6, 5), 90));
}

void add_not_manifold(std::vector<ShapeFigures>& all) {
  all.push_back(not_manifold("tetrahedra sharing a vertex", shapes::two_tetrahedra_sharing_vertex(),
                             12, 3 + sqrt3));
  all.back().edge_components = 2;
  all.back().non_manifold_vertices = all.back().pinched_vertices = 1;
  all.push_back(not_manifold("tetrahedra sharing an edge", shapes::two_tetrahedra_sharing_edge(),
                             11, 3 + sqrt3));
  all.back().non_manifold_edges = 1;
  all.back().non_manifold_vertices = 2;
  all.push_back(not_manifold("tetrahedra sharing a face", shapes::two_tetrahedra_sharing_face(), 9,
                             3 + sqrt3));
  all.back().non_manifold_edges = all.back().non_manifold_vertices = 3;
  // Each face stands on an edge of length 1; the others' corners are 1 and twice sqrt 2 away from
  // it.
  all.push_back(not_manifold("fan of three", shapes::fan_of_three(), 7, 0.5 + sqrt2));
  all.back().boundaries = 3;
  all.back().border_edges = 6;
  all.back().non_manifold_edges = 1;
  all.back().non_manifold_vertices = 2;
}

}  // namespace

std::vector<ShapeFigures> all_shapes() {
  std::vector<ShapeFigures> all;
  add_solids(all);
  add_open_and_one_sided(all);
  add_not_manifold(all);
  return all;
}

}  // namespace meshalyzer
