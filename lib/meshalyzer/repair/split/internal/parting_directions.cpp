#include "meshalyzer/repair/split/internal/parting_directions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace meshalyzer {
namespace {

/// The number of steps of the search for the direction behind all faces: its error decreases like
/// the inverse of that.
constexpr std::size_t kSearchSteps = 64;
/// Below this, no direction is behind all faces.
constexpr double kMinDepth = 1e-6;

/// Returns the direction from p to q, with a longest coordinate of 1; zero if p and q coincide or
/// the difference overflows.
Vec3 direction(const Vec3& p, const Vec3& q) {
  const Vec3 d = q - p;
  const double size = d.cwiseAbs().maxCoeff();
  return std::isfinite(size) && size > 0.0 ? Vec3(d / size) : Vec3(Vec3::Zero());
}

/// Returns unit vectors against the normals of the faces; those of zero area have none.
std::vector<Vec3> inward_normals(std::span<const Corners> faces) {
  std::vector<Vec3> result;
  for (const Corners& face : faces) {
    const Vec3 normal = direction(face[0], face[2]).cross(direction(face[0], face[1]));
    if (normal.squaredNorm() > 0.0) result.push_back(normal.normalized());
  }
  return result;
}

/// Returns the direction that maximises the smallest product with unit vectors: that of the point
/// nearest to the origin in their convex hull (Gilbert 1966, "An iterative procedure for computing
/// the minimum of a quadratic form on a convex set"). Zero if no direction has only positive
/// products.
Vec3 deepest_direction(std::span<const Vec3> vectors) {
  Vec3 nearest = Vec3::Zero();
  for (const Vec3& v : vectors) nearest += v / static_cast<double>(vectors.size());
  for (std::size_t step = 0; step < kSearchSteps; ++step) {
    const Vec3& lowest = *std::min_element(
        vectors.begin(), vectors.end(),
        [&](const Vec3& v, const Vec3& w) { return nearest.dot(v) < nearest.dot(w); });
    const Vec3 way = lowest - nearest;
    if (way.squaredNorm() == 0.0) break;
    nearest += std::clamp(-nearest.dot(way) / way.squaredNorm(), 0.0, 1.0) * way;
  }
  const bool is_behind_all = std::all_of(vectors.begin(), vectors.end(), [&](const Vec3& v) {
    return nearest.dot(v) > kMinDepth * nearest.norm();
  });
  return is_behind_all ? nearest : Vec3(Vec3::Zero());
}

/// Adds a direction and the opposite one.
void append_both(const Vec3& d, std::vector<Vec3>& directions) {
  const Vec3 unit = direction(Vec3::Zero(), d);
  if (unit.isZero(0.0)) return;
  directions.push_back(unit);
  directions.emplace_back(-unit);
}

}  // namespace

std::vector<Vec3> parting_directions(std::span<const Corners> faces) {
  std::vector<Vec3> directions;
  const std::vector<Vec3> inward = inward_normals(faces);
  if (!inward.empty()) {
    append_both(deepest_direction(inward), directions);
    Vec3 mean = Vec3::Zero();
    for (const Vec3& v : inward) mean += v;
    append_both(mean, directions);
  }
  Vec3 middle = Vec3::Zero();
  for (const Corners& face : faces) {
    middle += direction(face[0], face[1]) + direction(face[0], face[2]);
  }
  append_both(middle, directions);
  return directions;
}

const std::vector<Vec3>& grid_directions() {
  static const std::vector<Vec3> directions = [] {
    std::vector<Vec3> all;
    for (int i = 0; i < 27; ++i) {
      if (i != 13) all.emplace_back(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    }
    return all;
  }();
  return directions;
}

}  // namespace meshalyzer
