#include "curvature.h"

#include <stdexcept>

namespace lab {

double angle_defect(const TriMesh& /*mesh*/, VertexHandle /*vertex*/) {
  throw std::logic_error("not done yet: exercise 5 a");
}

double one_ring_area(const TriMesh& /*mesh*/, VertexHandle /*vertex*/) {
  throw std::logic_error("not done yet: exercise 5 b");
}

double voronoi_area(const TriMesh& /*mesh*/, VertexHandle /*vertex*/) {
  // The cotangent of the angle between a and b is dot product / length of the cross product.
  throw std::logic_error("not done yet: exercise 5 c");
}

std::optional<double> gaussian_curvature(const TriMesh& /*mesh*/, VertexHandle /*vertex*/) {
  throw std::logic_error("not done yet: exercise 5 d");
}

Vec3 cotangent_vector(const TriMesh& /*mesh*/, VertexHandle /*vertex*/) {
  // alpha and beta lie opposite to the edge from v_i to v_j, one in each of its two faces.
  throw std::logic_error("not done yet: exercise 5 e");
}

std::optional<double> mean_curvature(const TriMesh& /*mesh*/, VertexHandle /*vertex*/) {
  // On a sphere with outward normals the cotangent vector points outwards. Compare it with the
  // vertex normal.
  throw std::logic_error("not done yet: exercise 5 f");
}

}  // namespace lab
