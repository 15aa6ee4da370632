#include "meshalyzer/contour/mesh_region.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/contour/internal/faces_in_complex.h"
#include "meshalyzer/spatial/visit_meeting.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// A point belongs to the region from this winding number on.
constexpr double kInside = 0.5;
/// Points whose winding numbers differ by less than this from kInside lie at a hole.
constexpr double kMidway = 0.25;

/// Returns where a segment meets a triangle, as a share of its length, up to rounding (Möller and
/// Trumbore 1997, "Fast, minimum storage ray/triangle intersection").
std::optional<double> share_to(const Corners& t, const Vec3& from, const Vec3& to) {
  constexpr double kRounding = 0x1p-40;
  const Vec3 along = to - from;
  const Vec3 u = t[1] - t[0];
  const Vec3 v = t[2] - t[0];
  const Vec3 across = along.cross(v);
  const double determinant = u.dot(across);
  if (determinant == 0.0) return std::nullopt;
  const Vec3 start = from - t[0];
  const double x = start.dot(across) / determinant;
  const Vec3 turned = start.cross(u);
  const double y = along.dot(turned) / determinant;
  const double share = v.dot(turned) / determinant;
  if (!(x >= -kRounding && y >= -kRounding && x + y <= 1.0 + kRounding)) return std::nullopt;
  if (!(share >= 0.0 && share <= 1.0)) return std::nullopt;
  return share;
}

/// Collects the points where a segment meets the faces of a tree.
class SegmentHits {
 public:
  SegmentHits(const FaceTree& tree, const Vec3& from, const Vec3& to)
      : tree_(tree),
        from_(from),
        to_(to),
        box_{tree.map(from.cwiseMin(to)), tree.map(from.cwiseMax(to))} {}

  std::vector<double> find() {
    visit_meeting(tree_, box_, [&](std::size_t slot) {
      if (const auto share = share_to(tree_.corners(slot), from_, to_)) shares_.push_back(*share);
      return true;
    });
    sort_unique(shares_);
    return std::move(shares_);
  }

 private:
  const FaceTree& tree_;
  const Vec3& from_;
  const Vec3& to_;
  TreeBox box_;
  std::vector<double> shares_;
};

}  // namespace

MeshRegion::MeshRegion(const Soup& soup, const FaceTree& tree)
    : tree_(tree), winding_(faces_in_complex(soup), ExpectedQueries::Many) {}

bool MeshRegion::contains(const Vec3& point) const {
  return std::abs(winding_.at(point)) >= kInside;
}

bool MeshRegion::contains_one_of(const Vec3& first, const Vec3& second) const {
  const auto [a, b] = winding_.at_both(first, second);
  return (std::abs(a) >= kInside) != (std::abs(b) >= kInside);
}

bool MeshRegion::spans_hole_at(const Vec3& point) const {
  return std::abs(std::abs(winding_.at(point)) - kInside) < kMidway;
}

double MeshRegion::crossing(const Vec3& inside, const Vec3& outside) const {
  const std::vector<double> shares = SegmentHits(tree_, inside, outside).find();
  if (shares.empty()) return crossing_by_bisection(inside, outside);
  for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
    const double between = (shares[i] + shares[i + 1]) / 2.0;
    if (!contains(inside + between * (outside - inside))) return shares[i];
  }
  return shares.back();
}

double MeshRegion::crossing_by_bisection(const Vec3& inside, const Vec3& outside) const {
  constexpr int kSteps = 8;
  double in = 0.0;
  double out = 1.0;
  for (int i = 0; i < kSteps; ++i) {
    const double middle = (in + out) / 2.0;
    (contains(inside + middle * (outside - inside)) ? in : out) = middle;
  }
  return (in + out) / 2.0;
}

}  // namespace meshalyzer
