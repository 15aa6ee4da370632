#include "meshalyzer/repair/folds/internal/candidate_faces.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/geometry/edge_measures.h"
#include "meshalyzer/repair/folds/internal/fold_outline.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {
namespace {

/// Tells whether two consistently oriented faces with a common edge are folded onto each other.
bool is_folded(const PlacedFace& a, const PlacedFace& b, double max_angle) {
  // Below this the angle between rounded normals cannot be told from 0.
  constexpr double kLeastAngle = 1e-6;
  const double between =
      angle_between_degrees(accurate_normal(a.corners), accurate_normal(b.corners));
  return !(180.0 - between > std::max(max_angle, kLeastAngle));
}

bool is_flat(const PlacedFace& face, double degeneracy) {
  return !(accurate_normal(face.corners).stableNorm() > degeneracy * longest_side(face.corners));
}

bool is_clean_pair(const PlacedFace& a, const PlacedFace& b, double max_angle) {
  if (count_common_vertices(a, b) == 2 && is_folded(a, b, max_angle)) return false;
  return !are_in_contact(a, b);
}

}  // namespace

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
    worst = std::min(worst, shape_quality(face.corners));
  }
  return worst;
}

}  // namespace meshalyzer
