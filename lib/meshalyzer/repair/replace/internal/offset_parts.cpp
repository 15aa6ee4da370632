#include "meshalyzer/repair/replace/internal/offset_parts.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/repair/orient/bounds_solid.h"
#include "meshalyzer/topology/components.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace meshalyzer {
namespace {

/// Vertices move so many times the distance of their component at most.
constexpr double kMostAtCorners = 2.0;
/// Of the weight of the faces at a vertex, this share goes to a step along the mean normal, which
/// decides where the faces leave open how far it moves along them.
constexpr double kWeightOfMean = 1e-3;

/// Returns the distance by which a component is moved. Multiples of the golden ratio are spread
/// evenly modulo 1, and those of near numbers differ much: such components often lie side by side.
double distance_of_component(Index component, double least) {
  const double share = std::numbers::phi * (static_cast<double>(component) + 1.0);
  return least * (1.0 + share - std::floor(share));
}

/// The sums, over the faces at a vertex, that tell how it moves if the planes of all move outward
/// by 1: the step d that minimizes the sum of w (n . d - 1)^2 for unit normals n weighted by angle.
struct OffsetSums {
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Vec3 normals = Vec3::Zero();

  void add(const Vec3& weighted_normal) {
    const double weight = weighted_normal.norm();
    if (!(weight > 0.0)) return;
    squares += weighted_normal * weighted_normal.transpose() / weight;
    normals += weighted_normal;
  }

  [[nodiscard]] Vec3 step() const {
    const double of_mean = kWeightOfMean * squares.trace();
    if (!(of_mean > 0.0)) return Vec3::Zero();
    const Eigen::Matrix3d matrix = squares + of_mean * Eigen::Matrix3d::Identity();
    const Vec3 step = matrix.llt().solve(normals + of_mean * normals.stableNormalized());
    return step * std::min(1.0, kMostAtCorners / std::max(step.norm(), 1.0));
  }
};

/// #components: 1 for those that are moved.
std::vector<std::uint8_t> which_are_moved(const PreparedMesh& mesh, const Components& components) {
  const CutMesh& cut = mesh.cut();
  std::vector<std::uint8_t> is_moved = which_are_closed(cut, components);
  for (std::uint8_t& flag : is_moved) flag = flag == 0 ? 1 : 0;
  const std::vector<Index> component_of =
      components_of_file_faces(cut, components, mesh.soup().n_faces());
  for (const IntersectingPair& pair : mesh.intersecting_pairs()) {
    is_moved[component_of[pair.face_a]] = 1;
    is_moved[component_of[pair.face_b]] = 1;
  }
  return is_moved;
}

}  // namespace

PassResult offset_parts(const PassInput& input, double least) {
  const Soup& soup = input.tracked.soup;
  const CutMesh& cut = input.mesh.cut();
  const Components components = find_edge_components(cut);
  const std::vector<std::uint8_t> is_moved = which_are_moved(input.mesh, components);
  std::vector<OffsetSums> sums(soup.n_vertices());
  std::vector<double> distances(soup.n_vertices(), 0.0);
  for (std::size_t f = 0; f < components.of_face.size(); ++f) {
    if (is_moved[components.of_face[f]] == 0) continue;
    const Index face = cut.side.faces[f];
    const Corners corners = corners_of(soup, face);
    const double distance = distance_of_component(components.of_face[f], least);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = soup.triangles[face][k];
      sums[v].add(angle_weighted_normal(corners, k));
      distances[v] = distance;
    }
  }
  PassResult result;
  const Index op = result.edits.begin_operation();
  for (Index v = 0; v < soup.n_vertices(); ++v) {
    if (distances[v] == 0.0) continue;
    result.edits.moved_vertices.push_back(
        {op, v, soup.positions[v] + distances[v] * sums[v].step()});
  }
  return result;
}

}  // namespace meshalyzer
