#include "meshalyzer/repair/split/internal/faces_by_angle.h"

#include "meshalyzer/exact/predicates.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace meshalyzer {
namespace {

/// The half of the plane that a half-plane's trace lies in, counter-clockwise from the first one.
enum class Half : std::uint8_t { First, Left, Opposite, Right };

/// Half-planes that end at an edge, each through a point.
class HalfPlanes {
 public:
  /// @param first  A point that is not collinear with a and b.
  HalfPlanes(const Vec3& a, const Vec3& b, const Vec3& first)
      : a_(a), b_(b), first_(first), axis_(*projection_axis(a, b, first)) {}

  [[nodiscard]] Half half(const Vec3& apex) const {
    const Sign side = orient3d(a_, b_, first_, apex);
    if (side != 0) return side > 0 ? Half::Left : Half::Right;
    return orient2d(axis_, a_, b_, first_) == orient2d(axis_, a_, b_, apex) ? Half::First
                                                                            : Half::Opposite;
  }
  /// Tells which of two half-planes in the same half comes first.
  [[nodiscard]] bool comes_before(const Vec3& p, const Vec3& q, Half half) const {
    return (half == Half::Left || half == Half::Right) && orient3d(a_, b_, p, q) > 0;
  }

 private:
  Vec3 a_;
  Vec3 b_;
  Vec3 first_;
  Axis axis_;
};

/// Estimates angles round the edge from that of the first apex.
class Protractor {
 public:
  Protractor(const Vec3& a, const Vec3& b, const Vec3& first) : a_(a) {
    scale_ = std::max({a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()});
    const Vec3 z = scaled(b).normalized();
    const Vec3 arm = scaled(first);
    x_ = (arm - arm.dot(z) * z).normalized();
    y_ = z.cross(x_);
  }

  /// @param half  Limits the answer, which is 0 if it cannot be determined.
  [[nodiscard]] double angle(const Vec3& apex, Half half) const {
    if (half == Half::First) return 0.0;
    if (half == Half::Opposite) return std::numbers::pi;
    const Vec3 arm = scaled(apex);
    const double turn = std::atan2(arm.dot(y_), arm.dot(x_));
    if (half == Half::Left) return turn >= 0.0 ? std::min(turn, std::numbers::pi) : 0.0;
    return turn <= 0.0 ? 2 * std::numbers::pi + turn : std::numbers::pi;
  }

 private:
  /// Returns a point relative to a, halved and divided by the size of the coordinates, so that
  /// nothing overflows.
  [[nodiscard]] Vec3 scaled(const Vec3& p) const {
    const double size = std::max(scale_, p.cwiseAbs().maxCoeff());
    return size > 0.0 ? Vec3((p / 2 - a_ / 2) / size) : Vec3(Vec3::Zero());
  }

  Vec3 a_;
  double scale_ = 0.0;
  Vec3 x_;
  Vec3 y_;
};

/// Faces at one angle, in the order given.
struct Tie {
  /// Faces that begin a solid, ascending, and those that end one, descending: of coincident
  /// surfaces the lower is paired with the lower at all their edges.
  std::vector<FaceByAngle> against;
  std::vector<FaceByAngle> along;

  [[nodiscard]] bool is_mixed() const { return !against.empty() && !along.empty(); }
};

/// Lists the faces of a tie so that they alternate, as long as there are both.
///
/// @param last  The crossing of the face before.
/// @return      That of the last face of the tie.
Crossing append(const Tie& tie, Crossing last, std::vector<FaceByAngle>& order) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < tie.against.size() || j < tie.along.size()) {
    const bool wants_along = last == Crossing::Against;
    const bool takes_along = i == tie.against.size() || (wants_along && j < tie.along.size());
    order.push_back(takes_along ? tie.along[j++] : tie.against[i++]);
    last = takes_along ? Crossing::Along : Crossing::Against;
  }
  return last;
}

/// Lists the faces of all ties, beginning after one that is not mixed, if any, because it is known
/// whether material follows there. If all are mixed, solids touch each other all round, and the
/// first face listed has its material before it: the tie of the last one ends with its counterpart.
std::vector<FaceByAngle> alternate(const std::vector<Tie>& ties) {
  const auto found =
      std::find_if(ties.begin(), ties.end(), [](const Tie& tie) { return !tie.is_mixed(); });
  const auto start = found == ties.end() ? 0 : static_cast<std::size_t>(found - ties.begin());
  std::vector<std::vector<FaceByAngle>> parts(ties.size());
  Crossing last = found == ties.end() ? Crossing::Against : Crossing::Along;
  for (std::size_t i = 0; i < ties.size(); ++i) {
    const std::size_t k = (start + i) % ties.size();
    last = append(ties[k], last, parts[k]);
  }
  std::vector<FaceByAngle> order;
  for (const auto& part : parts) order.insert(order.end(), part.begin(), part.end());
  return order;
}

}  // namespace

FacesByAngle sort_by_angle(const Vec3& a, const Vec3& b, std::span<const FaceAtEdge> faces) {
  FacesByAngle result;
  std::vector<Index> sorted;
  for (Index i = 0; i < faces.size(); ++i) {
    (are_collinear(a, b, faces[i].apex) ? result.without_angle : sorted).push_back(i);
  }
  if (sorted.empty()) return result;

  const Vec3& first = faces[sorted.front()].apex;
  const HalfPlanes planes(a, b, first);
  std::vector<Half> halves(faces.size(), Half::First);
  for (const Index i : sorted) halves[i] = planes.half(faces[i].apex);
  const auto comes_before = [&](Index i, Index j) {
    if (halves[i] != halves[j]) return halves[i] < halves[j];
    return planes.comes_before(faces[i].apex, faces[j].apex, halves[i]);
  };
  std::stable_sort(sorted.begin(), sorted.end(), comes_before);

  const Protractor protractor(a, b, first);
  std::vector<Tie> ties;
  double angle = 0.0;
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const Index i = sorted[k];
    if (k == 0 || comes_before(sorted[k - 1], i)) {
      angle = std::max(angle, protractor.angle(faces[i].apex, halves[i]));
      ties.emplace_back();
    }
    Tie& tie = ties.back();
    (faces[i].crossing == Crossing::Against ? tie.against : tie.along).push_back({i, angle});
  }
  for (Tie& tie : ties) std::reverse(tie.along.begin(), tie.along.end());
  result.order = alternate(ties);
  return result;
}

}  // namespace meshalyzer
