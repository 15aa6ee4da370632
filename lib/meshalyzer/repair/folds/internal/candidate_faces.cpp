#include "meshalyzer/repair/folds/internal/candidate_faces.h"

#include "meshalyzer/exact/normal.h"
#include "meshalyzer/repair/folds/internal/fold_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace meshalyzer {
namespace {

/// Tells whether two consistently oriented faces with a common edge are folded onto each other.
bool is_folded(const PlacedFace& a, const PlacedFace& b, double max_angle) {
  // Below this the angle between rounded normals cannot be told from 0.
  constexpr double kLeastAngle = 1e-6;
  const Vec3 u = unit_normal(a);
  const Vec3 v = unit_normal(b);
  const double between = std::atan2(u.cross(v).norm(), u.dot(v)) * (180.0 / std::numbers::pi);
  return !(180.0 - between > std::max(max_angle, kLeastAngle));
}

bool is_flat(const PlacedFace& face, double degeneracy) {
  const Corners& t = face.corners;
  const double longest = std::max(
      {(t[1] - t[0]).stableNorm(), (t[2] - t[1]).stableNorm(), (t[0] - t[2]).stableNorm()});
  return !(accurate_normal(t[0], t[1], t[2]).stableNorm() > degeneracy * longest);
}

bool is_clean_pair(const PlacedFace& a, const PlacedFace& b, double max_angle) {
  if (count_common_vertices(a, b) == 2 && is_folded(a, b, max_angle)) return false;
  return !are_in_contact(a, b);
}

}  // namespace

Vec3 unit_normal(const PlacedFace& face) {
  return accurate_normal(face.corners[0], face.corners[1], face.corners[2]).stableNormalized();
}

std::optional<double> quality_of(const CandidateFaces& candidate) {
  double worst = 1.0;
  for (std::size_t i = 0; i < candidate.faces.size(); ++i) {
    const PlacedFace& face = candidate.faces[i];
    if (is_flat(face, candidate.degeneracy)) return std::nullopt;
    const auto is_clean = [&](const PlacedFace& other) {
      return is_clean_pair(face, other, candidate.max_foldover_angle);
    };
    if (!std::all_of(candidate.faces.begin(),
                     candidate.faces.begin() + static_cast<std::ptrdiff_t>(i), is_clean) ||
        !std::all_of(candidate.around.begin(), candidate.around.end(), is_clean)) {
      return std::nullopt;
    }
    worst = std::min(worst, shape_quality(face.corners[0], face.corners[1], face.corners[2]));
  }
  return worst;
}

}  // namespace meshalyzer
