#include "meshalyzer/contour/boundary_samples.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/contour/internal/faces_in_complex.h"
#include "meshalyzer/mesh/used_box.h"
#include "meshalyzer/spatial/winding_number.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer {
namespace {

/// The distance between samples, as a share of the diagonal.
constexpr double kSampleSpacing = 1.0 / 128.0;
/// Winding numbers up to the first are certainly outside, from the second on certainly inside.
constexpr double kClearlyOutside = 0.25;
constexpr double kClearlyInside = 0.75;

/// Finds samples on single pieces.
class BoundarySampler {
 public:
  BoundarySampler(const Soup& mesh, double reach)
      : windings_(faces_in_complex(mesh), ExpectedQueries::Many),
        spacing_(kSampleSpacing * used_box(mesh).diagonal().norm()),
        reach_(reach) {}

  /// Appends the samples on a piece, which is halved along its longest edges until it is small.
  void sample(const Corners& piece, std::vector<Vec3>& samples) const {
    const Vec3 normal = normal_of(piece);
    const double length = normal.norm();
    if (!(length > 0.0)) return;
    const Vec3 step = normal * (reach_ / length);
    std::vector<Corners> open{piece};
    while (!open.empty()) {
      const Corners t = open.back();
      open.pop_back();
      if (longest_side(t) > spacing_) {
        const auto [first, second] = halve_longest_edge(t);
        open.push_back(second);
        open.push_back(first);
      } else if (const Vec3 middle = centroid_of(t); is_boundary(middle, step)) {
        samples.push_back(middle);
      }
    }
  }

 private:
  [[nodiscard]] bool is_boundary(const Vec3& p, const Vec3& step) const {
    const auto [front, behind] = windings_.at_both(p + step, p - step);
    const double least = std::min(std::abs(front), std::abs(behind));
    const double most = std::max(std::abs(front), std::abs(behind));
    return least <= kClearlyOutside && most >= kClearlyInside;
  }

  WindingNumbers windings_;
  double spacing_;
  double reach_;
};

}  // namespace

std::vector<Vec3> sample_boundary(const Soup& mesh, std::span<const Corners> pieces, double reach) {
  constexpr std::size_t kPieces = 64;
  if (pieces.empty()) return {};
  const BoundarySampler sampler(mesh, reach);
  std::vector<std::vector<Vec3>> of_chunk(n_chunks(pieces.size(), kPieces));
  parallel_chunks(pieces.size(), kPieces, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      sampler.sample(pieces[i], of_chunk[chunk.number]);
    }
  });
  std::vector<Vec3> all;
  for (const auto& samples : of_chunk) all.insert(all.end(), samples.begin(), samples.end());
  return all;
}

}  // namespace meshalyzer
