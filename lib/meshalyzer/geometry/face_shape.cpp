#include "meshalyzer/geometry/face_shape.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/geometry/face_measures.h"

#include <algorithm>
#include <numbers>

namespace meshalyzer {
namespace {

constexpr double kPi = std::numbers::pi;

/// Returns the vectors from each corner to the next.
std::array<Vec3, 3> edges_of(const Corners& corner) {
  return {corner[1] - corner[0], corner[2] - corner[1], corner[0] - corner[2]};
}

/// Returns the limit of the angles of a face that has no area left.
std::array<double, 3> flat_angles(const std::array<Vec3, 3>& edge, std::size_t longest) {
  if (edge[longest].isZero(0.0)) {
    return {kPi / 3, kPi / 3, kPi / 3};
  }
  std::array<double, 3> angle{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (edge[i].isZero(0.0)) {
      angle[i] = angle[(i + 1) % 3] = kPi / 2;
      return angle;
    }
  }
  angle[(longest + 2) % 3] = kPi;
  return angle;
}

FaceShape measure(const ScaledFace& face) {
  const std::array<Vec3, 3> edge = edges_of(face.corner);
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (edge[i].squaredNorm() > edge[longest].squaredNorm()) longest = i;
  }
  // The differences are shortest from the corner opposite to the longest edge, which loses the
  // least.
  const std::size_t apex = (longest + 2) % 3;
  const Vec3 normal = accurate_normal(face.corner, apex);
  const double twice_area = normal.stableNorm();
  FaceShape shape{.exponent = face.exponent};
  if (twice_area == 0.0) {
    shape.angle = flat_angles(edge, longest);
    return shape;
  }
  shape.normal = normal.stableNormalized();
  shape.area = twice_area / 2;
  for (std::size_t i = 0; i < 3; ++i) {
    shape.angle[i] = std::atan2(twice_area, -edge[i].dot(edge[(i + 2) % 3]));
  }
  return shape;
}

}  // namespace

ScaledFace scaled_face(const TriMesh& mesh, FaceHandle handle) {
  ScaledFace face{.corner = face_corners(mesh, handle)};
  auto& p = face.corner;
  const double size =
      std::max((p[1] - p[0]).cwiseAbs().maxCoeff(), (p[2] - p[0]).cwiseAbs().maxCoeff());
  const bool is_usual = size > 0x1p-200 && size < 0x1p200;
  if (!is_usual && size != 0.0) {
    face.exponent = length_exponent(size);
    p = times_power_of_two(p, -face.exponent);
  }
  return face;
}

std::vector<FaceShape> measure_face_shapes(const TriMesh& mesh) {
  std::vector<FaceShape> shapes(mesh.n_faces());
  parallel_chunks(shapes.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      shapes[i] = measure(scaled_face(mesh, FaceHandle(static_cast<int>(i))));
    }
  });
  return shapes;
}

}  // namespace meshalyzer
