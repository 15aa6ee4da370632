#include "meshalyzer/repair/split/internal/parting_directions.h"

#include "meshalyzer/arrangement/round_vertices.h"
#include "meshalyzer/spatial/direction_off.h"

#include <cmath>

namespace meshalyzer {
namespace {

/// A direction that leaves a face more slowly than this is as good as none.
constexpr double kLeastClearance = 1e-6;
/// The spacing of the grid that the direction behind all faces is rounded to: symmetric faces are
/// moved along a diagonal, and not beside it by some roundings.
constexpr double kDirectionSpacing = 0x1p-26;

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
    const DirectionOff behind = direction_off(inward);
    if (behind.clearance > kLeastClearance) {
      append_both(nearest_on_grid(behind.direction, kDirectionSpacing), directions);
    }
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
