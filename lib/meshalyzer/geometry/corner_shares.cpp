#include "meshalyzer/geometry/corner_shares.h"

#include "meshalyzer/base/parallel.h"

#include <cmath>

namespace meshalyzer {
namespace {

constexpr double kEighth = 0.125;

/// The scalar product of the two sides at each corner, and the squared length of the opposite side.
struct Sides {
  std::array<double, 3> dot{};
  std::array<double, 3> opposite2{};
};

Sides sides_of(const Corners& corner) {
  Sides sides;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& next = corner[(i + 1) % 3];
    const Vec3& previous = corner[(i + 2) % 3];
    sides.dot[i] = (next - corner[i]).dot(previous - corner[i]);
    sides.opposite2[i] = (previous - next).squaredNorm();
  }
  return sides;
}

/// Returns the areas of the circumcentric cells: (cot b |ac|^2 + cot c |ab|^2) / 8 at corner a,
/// where the cotangent is the scalar product over twice the area.
CornerShares voronoi(const Sides& sides, double area) {
  CornerShares shares;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    shares[i] =
        (sides.dot[j] / area * sides.opposite2[j] + sides.dot[k] / area * sides.opposite2[k]) /
        area * (kEighth / 2);
  }
  return shares;
}

CornerShares mixed(const Sides& sides, double area) {
  for (std::size_t obtuse = 0; obtuse < 3; ++obtuse) {
    if (sides.dot[obtuse] < 0.0) {
      CornerShares shares{0.25, 0.25, 0.25};
      shares[obtuse] = 0.5;
      return shares;
    }
  }
  return voronoi(sides, area);
}

CornerShares shares_of(const TriMesh& mesh, FaceHandle face, const FaceShape& shape,
                       VertexArea area) {
  if (shape.area == 0.0) {
    return {0.0, 0.0, 0.0};
  }
  if (area == VertexArea::OneRing) {
    return {1.0, 1.0, 1.0};
  }
  if (area == VertexArea::Barycentric) {
    return {1.0 / 3, 1.0 / 3, 1.0 / 3};
  }
  const Sides sides = sides_of(scaled_face(mesh, face).corner);
  return area == VertexArea::Mixed ? mixed(sides, shape.area) : voronoi(sides, shape.area);
}

}  // namespace

std::vector<CornerShares> corner_shares(const TriMesh& mesh, const std::vector<FaceShape>& shapes,
                                        VertexArea area) {
  std::vector<CornerShares> shares(shapes.size());
  parallel_chunks(shares.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      shares[i] = shares_of(mesh, FaceHandle(static_cast<int>(i)), shapes[i], area);
    }
  });
  return shares;
}

}  // namespace meshalyzer
