#include "meshalyzer/spatial/far_field.h"

#include "meshalyzer/base/triangle.h"

#include <algorithm>

namespace meshalyzer {
namespace {

Vec3 middle_of(const Corners& t) {
  return (t[0] + (t[1] + t[2])) / 3.0;
}

}  // namespace

void FarField::add(const Corners& d, const Vec3& n) {
  const Vec3 sum = d[0] + (d[1] + d[2]);
  const Vec3 mean = sum / 3.0;
  squares += mean.cwiseProduct(n);
  mixed += Vec3(mean.y() * n.z() + mean.z() * n.y(), mean.z() * n.x() + mean.x() * n.z(),
                mean.x() * n.y() + mean.y() * n.x());
  // The means over the triangle of products of two coordinates.
  const auto product = [&](int i, int j) {
    const double of_corners = d[0][i] * d[0][j] + (d[1][i] * d[1][j] + d[2][i] * d[2][j]);
    return (of_corners + sum[i] * sum[j]) / 12.0;
  };
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    cubes[i] += product(i, i) * n[i];
    with_next[i] += product(j, j) * n[i] + 2.0 * product(i, j) * n[j];
    with_last[i] += product(k, k) * n[i] + 2.0 * product(i, k) * n[k];
    of_all += 2.0 * product(j, k) * n[i];
  }
}

void FarField::remove_traces() {
  squares.array() -= squares.sum() / 3.0;
  const Vec3 trace = (3.0 * cubes + with_next + with_last) / 5.0;
  cubes -= trace;
  with_next -= trace;
  with_last -= trace;
}

FarField far_field_of(std::span<const Corners> triangles, double far) {
  FarField field;
  double weight = 0.0;
  for (const Corners& t : triangles) {
    const Vec3 area = normal_of(t) / 2.0;
    field.area += area;
    field.centre += area.norm() * middle_of(t);
    weight += area.norm();
  }
  if (!(weight > 0.0)) {
    return {};
  }
  field.centre /= weight;
  double radius_squared = 0.0;
  for (const Corners& t : triangles) {
    const Corners offsets{t[0] - field.centre, t[1] - field.centre, t[2] - field.centre};
    field.add(offsets, normal_of(t) / 2.0);
    for (const Vec3& d : offsets) radius_squared = std::max(radius_squared, d.squaredNorm());
  }
  field.remove_traces();
  field.far_squared = far * far * radius_squared;
  return field;
}

}  // namespace meshalyzer
