#include "meshalyzer/contour/boundary_samples.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/contour/internal/faces_in_complex.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer {
namespace {

/// Winding numbers up to the first are certainly outside, from the second on certainly inside.
constexpr double kClearlyOutside = 0.25;
constexpr double kClearlyInside = 0.75;

/// Appends the samples of a piece, which is halved along its longest edges until it is small.
void sample_piece(const Corners& piece, Index number, double spacing,
                  std::vector<PieceSample>& samples) {
  if (!(normal_of(piece).norm() > 0.0)) return;
  std::vector<Corners> open{piece};
  while (!open.empty()) {
    const Corners t = open.back();
    open.pop_back();
    if (longest_side(t) > spacing) {
      const auto [first, second] = halve_longest_edge(t);
      open.push_back(second);
      open.push_back(first);
    } else {
      samples.push_back({centroid_of(t), number});
    }
  }
}

}  // namespace

std::vector<PieceSample> sample_pieces(std::span<const Corners> pieces, double spacing) {
  return collect_chunks<PieceSample>(
      pieces.size(), [&](Chunk chunk, std::vector<PieceSample>& samples) {
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
          sample_piece(pieces[i], static_cast<Index>(i), spacing, samples);
        }
      });
}

SolidBoundary::SolidBoundary(const Soup& mesh, double reach)
    : windings_(faces_in_complex(mesh), ExpectedQueries::Many, WindingAccuracy::Coarse),
      reach_(reach) {}

bool SolidBoundary::is_at(const Vec3& point, const Corners& piece) const {
  const Vec3 normal = normal_of(piece);
  const double length = normal.norm();
  if (!(length > 0.0)) return false;
  const Vec3 step = normal * (reach_ / length);
  const auto [front, behind] = windings_.at_both(point + step, point - step);
  const double least = std::min(std::abs(front), std::abs(behind));
  const double most = std::max(std::abs(front), std::abs(behind));
  return least <= kClearlyOutside && most >= kClearlyInside;
}

}  // namespace meshalyzer
