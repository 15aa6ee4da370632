#include "meshalyzer/repair/split/internal/tip_lid.h"

#include "meshalyzer/exact/predicates.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>

namespace meshalyzer {
namespace {

/// Cuts off ears of a ring that lie on one side of the tip.
class LidOnOneSide {
 public:
  /// @param side  The sense in which the apex sees the ears.
  LidOnOneSide(const Vec3& apex, std::span<const Vec3> ring, std::span<const Vec3> others,
               Sign side)
      : apex_(apex), ring_(ring), others_(others), side_(side), left_(ring.size()) {
    std::iota(left_.begin(), left_.end(), Index{0});
  }

  std::optional<std::vector<Triangle>> run() {
    std::vector<Triangle> ears;
    while (left_.size() > 2) {
      const std::optional<std::size_t> tip = best_ear();
      if (!tip) return std::nullopt;
      ears.push_back(ear_at(*tip));
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(*tip));
    }
    return ears;
  }

 private:
  /// Returns the triangle of a point that is left, and of its neighbours.
  [[nodiscard]] Triangle ear_at(std::size_t i) const {
    const std::size_t n = left_.size();
    return {left_[(i + n - 1) % n], left_[i], left_[(i + 1) % n]};
  }

  /// Returns the place of the ear with the shortest diagonal.
  [[nodiscard]] std::optional<std::size_t> best_ear() const {
    std::optional<std::size_t> best;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const Triangle ear = ear_at(i);
      const double diagonal = (ring_[ear[2]] - ring_[ear[0]]).stableNorm();
      if (!(diagonal < shortest) || !is_ear(ear)) continue;
      best = i;
      shortest = diagonal;
    }
    return best;
  }

  [[nodiscard]] bool is_ear(const Triangle& t) const {
    if (orient3d(apex_, ring_[t[0]], ring_[t[1]], ring_[t[2]]) != side_) return false;
    const bool hides_ring = std::any_of(left_.begin(), left_.end(), [&](Index v) {
      return std::find(t.begin(), t.end(), v) == t.end() && hides(t, ring_[v]);
    });
    return !hides_ring && std::none_of(others_.begin(), others_.end(),
                                       [&](const Vec3& point) { return hides(t, point); });
  }

  /// Tells whether a point lies in the direction of a triangle, or on its border, as seen from the
  /// apex.
  [[nodiscard]] bool hides(const Triangle& t, const Vec3& point) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (orient3d(apex_, ring_[t[i]], ring_[t[(i + 1) % 3]], point) == -side_) return false;
    }
    return true;
  }

  const Vec3& apex_;
  std::span<const Vec3> ring_;
  std::span<const Vec3> others_;
  Sign side_;
  /// The points of the ring that are left, in order.
  std::vector<Index> left_;
};

}  // namespace

std::optional<std::vector<Triangle>> close_tip(const Vec3& apex, std::span<const Vec3> ring,
                                               std::span<const Vec3> others) {
  for (const Sign side : {1, -1}) {
    if (auto lid = LidOnOneSide(apex, ring, others, side).run()) return lid;
  }
  return std::nullopt;
}

}  // namespace meshalyzer
