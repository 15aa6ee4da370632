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

double twice_area_seen_from(const Corners& p, std::size_t apex) {
  return accurate_normal(p, apex).stableNorm();
}

double angle_degrees(double sine, double cosine) {
  return std::atan2(sine, cosine) * (180.0 / std::numbers::pi);
}

double dot_product_at(const Corners& p, std::size_t corner) {
  return (p[(corner + 1) % 3] - p[corner]).dot(p[(corner + 2) % 3] - p[corner]);
}

/// Returns the angle at a corner when products of lengths leave the range of doubles, computed at
/// another scale.
double rescaled_angle(const Corners& p, std::size_t corner) {
  double largest = 0.0;
  for (const Vec3& point : p) {
    largest = std::max(largest, point.lpNorm<Eigen::Infinity>());
  }
  const int exponent = std::ilogb(largest);
  const Corners scaled = times_power_of_two(p, -exponent);
  return angle_degrees(twice_area_seen_from(scaled, corner), dot_product_at(scaled, corner));
}

/// Returns the angle at a corner. Sine and cosine have the same factor, a product of lengths.
double corner_angle(const Corners& p, std::size_t corner, double twice_area) {
  const double dot_product = dot_product_at(p, corner);
  return std::isnormal(twice_area) && std::isfinite(dot_product)
             ? angle_degrees(twice_area, dot_product)
             : rescaled_angle(p, corner);
}

/// @param side  The lengths of the sides from each corner to the next.
Figures measure(const Corners& p, const std::array<double, 3>& side) {
  const std::array<double, 3> opposite{side[1], side[2], side[0]};
  // The differences are shortest from the corner opposite to the longest edge, which loses the
  // least.
  const auto apex = static_cast<std::size_t>(std::max_element(opposite.begin(), opposite.end()) -
                                             opposite.begin());
  const double twice_area = twice_area_seen_from(p, apex);
  // The altitude on the longest edge is twice_area / longest; dividing in two steps avoids an early
  // overflow.
  const double longest = opposite[apex];
  // The smallest angle is opposite to the shortest edge.
  const auto sharpest = static_cast<std::size_t>(
      std::min_element(opposite.begin(), opposite.end()) - opposite.begin());
  return {twice_area / 2, longest / (twice_area / longest), corner_angle(p, sharpest, twice_area)};
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
      if (are_collinear(p[0], p[1], p[2])) {
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
