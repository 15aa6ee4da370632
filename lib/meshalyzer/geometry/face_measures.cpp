#include "meshalyzer/geometry/face_measures.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/exact/predicates.h"

#include <algorithm>
#include <array>
#include <limits>

namespace meshalyzer {
namespace {

struct Measure2 {
  double area;
  double aspect_ratio;
};

Measure2 measure(const std::array<Vec3, 3>& p) {
  std::array<double, 3> opposite;
  for (std::size_t i = 0; i < 3; ++i) {
    opposite[i] = (p[(i + 2) % 3] - p[(i + 1) % 3]).stableNorm();
  }
  // Seen from the corner opposite to the longest edge the differences are shortest, so least is
  // lost.
  const auto apex = static_cast<std::size_t>(std::max_element(opposite.begin(), opposite.end()) -
                                             opposite.begin());
  const double twice_area =
      accurate_normal(p[apex], p[(apex + 1) % 3], p[(apex + 2) % 3]).stableNorm();
  // Altitude on the longest edge = twice_area / longest; divided in two steps, so that nothing
  // overflows early.
  const double longest = opposite[apex];
  return {twice_area / 2, longest / (twice_area / longest)};
}

}  // namespace

std::array<Vec3, 3> face_corners(const TriMesh& mesh, FaceHandle face) {
  const HalfedgeHandle h = mesh.halfedge_handle(face);
  const HalfedgeHandle next = mesh.next_halfedge_handle(h);
  return {mesh.point(mesh.to_vertex_handle(h)), mesh.point(mesh.to_vertex_handle(next)),
          mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(next)))};
}

FaceMeasures measure_faces(const TriMesh& mesh) {
  FaceMeasures measures;
  measures.area.resize(mesh.n_faces());
  measures.aspect_ratio.resize(mesh.n_faces());
  std::vector<std::vector<FaceHandle>> zero_area(n_chunks(mesh.n_faces()));
  parallel_chunks(mesh.n_faces(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const FaceHandle face(static_cast<int>(i));
      const std::array<Vec3, 3> p = face_corners(mesh, face);
      if (are_collinear(p[0], p[1], p[2])) {
        measures.area[i] = 0.0;
        measures.aspect_ratio[i] = std::numeric_limits<double>::infinity();
        zero_area[chunk.number].push_back(face);
      } else {
        const Measure2 m = measure(p);
        measures.area[i] = m.area;
        measures.aspect_ratio[i] = m.aspect_ratio;
      }
    }
  });
  for (const auto& part : zero_area) {
    measures.zero_area.insert(measures.zero_area.end(), part.begin(), part.end());
  }
  return measures;
}

}  // namespace meshalyzer
