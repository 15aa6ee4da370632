#include "meshalyzer/repair/folds/fold_trial.h"

#include "meshalyzer/exact/normal.h"
#include "meshalyzer/repair/folds/fold_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace meshalyzer {
namespace {

/// Two faces, the vertices that they have in common first and in the same order.
struct Aligned {
  Corners a;
  Corners b;
  std::size_t n_common = 0;
};

Aligned align(PlacedFace a, PlacedFace b) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto found = std::find(b.vertices.begin() + static_cast<std::ptrdiff_t>(n),
                                 b.vertices.end(), a.vertices[i]);
    if (found == b.vertices.end()) continue;
    const auto j = static_cast<std::size_t>(found - b.vertices.begin());
    std::swap(a.vertices[i], a.vertices[n]);
    std::swap(a.corners[i], a.corners[n]);
    std::swap(b.vertices[j], b.vertices[n]);
    std::swap(b.corners[j], b.corners[n]);
    ++n;
  }
  return {a.corners, b.corners, n};
}

bool touch(const Aligned& faces) {
  const auto common = static_cast<Common>(faces.n_common);
  return !are_clearly_apart(faces.a, faces.b, common) &&
         find_contact(faces.a, faces.b, common).has_value();
}

Vec3 unit_normal(const PlacedFace& face) {
  return accurate_normal(face.corners[0], face.corners[1], face.corners[2]).stableNormalized();
}

/// Of two consistently oriented faces with an edge in common.
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
  const Aligned aligned = align(a, b);
  if (aligned.n_common == 2 && is_folded(a, b, max_angle)) return false;
  return !touch(aligned);
}

}  // namespace

bool is_contact(const PlacedFace& a, const PlacedFace& b) {
  return touch(align(a, b));
}

std::optional<double> quality_of(const FoldTrial& trial) {
  double worst = 1.0;
  for (std::size_t i = 0; i < trial.faces.size(); ++i) {
    const PlacedFace& face = trial.faces[i];
    if (is_flat(face, trial.degeneracy)) return std::nullopt;
    const auto is_clean = [&](const PlacedFace& other) {
      return is_clean_pair(face, other, trial.max_foldover_angle);
    };
    if (!std::all_of(trial.faces.begin(), trial.faces.begin() + static_cast<std::ptrdiff_t>(i),
                     is_clean) ||
        !std::all_of(trial.around.begin(), trial.around.end(), is_clean)) {
      return std::nullopt;
    }
    worst = std::min(worst, shape_quality(face.corners[0], face.corners[1], face.corners[2]));
  }
  return worst;
}

}  // namespace meshalyzer
