#include "meshalyzer/base/triangle.h"
#include "meshalyzer/defects/opposed_normals.h"
#include "meshalyzer/geometry/vertex_normals.h"
#include "meshalyzer/repair/passes.h"

#include <algorithm>
#include <vector>

namespace meshalyzer {
namespace {

/// A sum of normals of faces, each times its weight.
struct NormalSum {
  Vec3 sum = Vec3::Zero();
  double weight = 0.0;

  [[nodiscard]] bool is_cancelled() const { return sum.norm() <= kNormalsCancel * weight; }
};

/// Sums the normals of the faces that have each of the normals given at its vertex, weighted by
/// their angles there.
/// @param given  Ascending.
std::vector<NormalSum> sums_of_faces(const Soup& soup, const std::vector<GivenNormal>& given) {
  std::vector<NormalSum> sums(given.size());
  for (Index f = 0; f < soup.n_faces(); ++f) {
    if (!is_in_complex(soup.triangles[f])) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const GivenNormal here{soup.triangles[f][k], soup.corner_normals[f][k]};
      const auto found = std::lower_bound(given.begin(), given.end(), here);
      if (found == given.end() || *found != here) continue;
      const Vec3 normal = angle_weighted_normal(corners_of(soup, f), k);
      NormalSum& sum = sums[static_cast<std::size_t>(found - given.begin())];
      sum.sum += normal;
      sum.weight += normal.norm();
    }
  }
  return sums;
}

}  // namespace

PassResult renew_normals(const PassInput& input) {
  PassResult result;
  const std::vector<GivenNormal> opposed = opposed_normals(input.mesh);
  if (opposed.empty()) return result;
  const std::vector<NormalSum> sums = sums_of_faces(input.tracked.soup, opposed);
  for (std::size_t i = 0; i < opposed.size();) {
    const Index vertex = opposed[i].vertex;
    std::size_t end = i;
    bool is_cancelled = false;
    for (; end < opposed.size() && opposed[end].vertex == vertex; ++end) {
      is_cancelled = is_cancelled || sums[end].is_cancelled();
    }
    if (is_cancelled) {
      result.refused.push_back({.code = DefectCode::VertexNormal,
                                .vertex = vertex,
                                .reason = "the normals of its faces cancel each other"});
      i = end;
      continue;
    }
    const Index op = result.edits.begin_operation();
    for (; i < end; ++i) {
      result.edits.changed_normals.push_back(
          {op, vertex, opposed[i].normal, sums[i].sum.normalized()});
    }
  }
  return result;
}

}  // namespace meshalyzer
