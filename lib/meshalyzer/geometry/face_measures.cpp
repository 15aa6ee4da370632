#include "meshalyzer/geometry/face_measures.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/geometry/edge_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace meshalyzer {
namespace {

/// The figures of a face that has an area.
struct Figures {
  double area;
  double aspect_ratio;
  double corner_angle;
};

/// The lengths and products from which the figures follow.
struct Products {
  double twice_area;
  double longest_side_squared;
  /// The dot product of the two sides at the sharpest corner.
  double dot_product;
};

double dot_product_at(const Corners& p, std::size_t corner) {
  return (p[(corner + 1) % 3] - p[corner]).dot(p[(corner + 2) % 3] - p[corner]);
}

/// @param side  The lengths of the sides from each corner to the next.
Products products_of(const Corners& p, const std::array<double, 3>& side) {
  const std::array<double, 3> opposite{side[1], side[2], side[0]};
  // The differences are shortest from the corner opposite to the longest edge, which loses the
  // least.
  const auto apex = static_cast<std::size_t>(std::max_element(opposite.begin(), opposite.end()) -
                                             opposite.begin());
  // The smallest angle is opposite to the shortest edge.
  const auto sharpest = static_cast<std::size_t>(
      std::min_element(opposite.begin(), opposite.end()) - opposite.begin());
  return {accurate_normal(p, apex).stableNorm(),
          (p[(apex + 2) % 3] - p[(apex + 1) % 3]).squaredNorm(), dot_product_at(p, sharpest)};
}

Figures figures_of(const Products& of) {
  // The altitude on the longest edge is twice_area / longest. No root is taken, so that half a
  // square has a ratio of 2 exactly. Sine and cosine of the angle have the same factor, a product
  // of lengths.
  return {of.twice_area / 2, of.longest_side_squared / of.twice_area,
          std::atan2(of.twice_area, of.dot_product) * (180.0 / std::numbers::pi)};
}

/// @param side  The lengths of the sides from each corner to the next.
Figures measure(const Corners& p, const std::array<double, 3>& side) {
  const Products products = products_of(p, side);
  if (is_of_usual_scale(products.twice_area) && std::isfinite(products.dot_product) &&
      std::isfinite(products.longest_side_squared)) {
    return figures_of(products);
  }
  // The figures of a face that is about as large as 1, but for its area, which alone may overflow
  // or underflow.
  const int exponent = size_exponent(p);
  const Corners smaller = made_smaller(p, exponent);
  Figures figures = figures_of(products_of(smaller, side_lengths(smaller)));
  figures.area = std::ldexp(figures.area, 2 * exponent);
  return figures;
}

/// Returns the lengths of the sides from each of face_corners() to the next.
std::array<double, 3> side_lengths(const TriMesh& mesh, FaceHandle face,
                                   std::span<const double> edge_lengths) {
  const auto length = [&](HalfedgeHandle h) {
    return edge_lengths[static_cast<std::size_t>(mesh.edge_handle(h).idx())];
  };
  const HalfedgeHandle last = mesh.halfedge_handle(face);
  const HalfedgeHandle first = mesh.next_halfedge_handle(last);
  return {length(first), length(mesh.next_halfedge_handle(first)), length(last)};
}

}  // namespace

Corners face_corners(const TriMesh& mesh, FaceHandle face) {
  const HalfedgeHandle h = mesh.halfedge_handle(face);
  const HalfedgeHandle next = mesh.next_halfedge_handle(h);
  return {mesh.point(mesh.to_vertex_handle(h)), mesh.point(mesh.to_vertex_handle(next)),
          mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(next)))};
}

FaceMeasures measure_faces(const TriMesh& mesh) {
  return measure_faces(mesh, mesh_edge_lengths(mesh));
}

FaceMeasures measure_faces(const TriMesh& mesh, std::span<const double> edge_lengths) {
  FaceMeasures measures;
  measures.area.resize(mesh.n_faces());
  measures.aspect_ratio.resize(mesh.n_faces());
  measures.corner_angle.resize(mesh.n_faces());
  std::vector<std::vector<FaceHandle>> zero_area(n_chunks(mesh.n_faces()));
  parallel_chunks(mesh.n_faces(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const FaceHandle face(static_cast<int>(i));
      const Corners p = face_corners(mesh, face);
      if (are_collinear(p)) {
        measures.area[i] = 0.0;
        measures.aspect_ratio[i] = std::numeric_limits<double>::infinity();
        measures.corner_angle[i] = 0.0;
        zero_area[chunk.number].push_back(face);
      } else {
        const Figures figures = measure(p, side_lengths(mesh, face, edge_lengths));
        measures.area[i] = figures.area;
        measures.aspect_ratio[i] = figures.aspect_ratio;
        measures.corner_angle[i] = figures.corner_angle;
      }
    }
  });
  for (const auto& part : zero_area) {
    measures.zero_area.insert(measures.zero_area.end(), part.begin(), part.end());
  }
  return measures;
}

}  // namespace meshalyzer
