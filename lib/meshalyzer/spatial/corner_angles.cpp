#include "meshalyzer/spatial/corner_angles.h"

#include "meshalyzer/base/parallel.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace meshalyzer {
namespace {

/// A vertex with at least so many faces is crowded.
constexpr Index kCrowd = 8;

/// The angles are worth their memory from so many pairs of corners at crowded vertices on, a face.
constexpr std::size_t kPairsPerFace = 16;

constexpr std::uint32_t kHalfTurn = std::uint32_t{1} << 31;

// How far a computed angle is from the true one. With u = 2^-53, an arm d from the vertex to
// another corner, and two coordinates of it across the axis, by vectors no longer than 1.001:
//
// - A coordinate of d is a difference, off by u of itself. Each of three products and two sums adds
//   at most u more of what it is made of: so each coordinate across is off by less than 5 u |d|.
// - Both together move the arm across by less than 8 u |d|, which turns it by less than 2^13 u if
//   it is at least 2^-10 |d| long.
// - The arctangent and its scaling add less than 2^-49 of a turn.
//
// That is less than 2^-39 of a turn altogether. Which two vectors they are, and that they are
// rounded themselves, does not matter: any two give coordinates of the plane seen along one axis.
// A floor is off by less than one unit, 2^-32 of a turn, so this is generous:
constexpr std::uint32_t kAngleSlack = 4;
constexpr double kShortestAcross = 0x1p-10;

/// Arms outside these bounds are not looked at, so that nothing overflows, and what underflows is
/// far below the errors above.
constexpr double kShortestArm = 0x1p-300;
constexpr double kLongestArm = 0x1p300;

/// Two directions across an axis.
struct Across {
  Vec3 first = Vec3::Zero();
  Vec3 second = Vec3::Zero();
};

Across directions_across(const Vec3& axis) {
  const double length = axis.stableNorm();
  if (!(length > 0.0) || !std::isfinite(length)) return {};
  const Vec3 first = axis.unitOrthogonal();
  return {first, (axis / length).cross(first)};
}

/// The angle under which an arm is seen; none where it runs along the axis.
std::optional<std::uint32_t> angle_of(const Across& across, const Vec3& arm) {
  const double length = arm.stableNorm();
  const double x = across.first.dot(arm);
  const double y = across.second.dot(arm);
  const bool is_usual =
      kShortestArm < length && length < kLongestArm && std::hypot(x, y) > kShortestAcross * length;
  if (!is_usual) return std::nullopt;
  const double turns = std::atan2(y, x) / (2 * std::numbers::pi);
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(turns * 0x1p32)));
}

/// The angles of a corner between two arms.
AngleRange range_between(const Across& across, const Vec3& arm_a, const Vec3& arm_b) {
  const auto a = angle_of(across, arm_a);
  const auto b = angle_of(across, arm_b);
  if (!a || !b) return {};
  const bool goes_from_a = *b - *a < kHalfTurn;
  const std::uint32_t width = goes_from_a ? *b - *a : *a - *b;
  if (width > kHalfTurn - 2 * kAngleSlack) return {};
  return {(goes_from_a ? *a : *b) - kAngleSlack, width + 2 * kAngleSlack};
}

/// Numbers the crowded vertices.
class Crowds {
 public:
  Crowds(const FaceTree& tree, std::span<const std::uint8_t> proven) : number_(tree.n_points(), 0) {
    for (std::size_t slot = 0; slot < tree.n_faces(); ++slot) {
      for (const Index v : tree.triangle(slot)) {
        if (proven.empty() || proven[v] == 0) ++number_[v];
      }
    }
    for (Index& number : number_) {
      const std::size_t n_faces = number;
      number = n_faces < kCrowd ? kNoIndex : static_cast<Index>(count_++);
      if (n_faces >= kCrowd) n_pairs_ += n_faces * n_faces / 2;
    }
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  /// The pairs of corners at all of them.
  [[nodiscard]] std::size_t n_pairs() const { return n_pairs_; }
  /// Returns the number of a vertex, or kNoIndex.
  [[nodiscard]] Index of(Index vertex) const { return number_[vertex]; }

 private:
  std::vector<Index> number_;
  std::size_t count_ = 0;
  std::size_t n_pairs_ = 0;
};

/// The axis of each crowd: the sum of the unit normals of its faces, so that most are seen from
/// above. Any would do.
std::vector<Across> look_along_normals(const FaceTree& tree, const Crowds& crowds) {
  std::vector<Vec3> axes(crowds.count(), Vec3::Zero());
  for (std::size_t slot = 0; slot < tree.n_faces(); ++slot) {
    const Triangle t = tree.triangle(slot);
    const Vec3 edge = (tree.point(t[1]) - tree.point(t[0])) * tree.scale();
    const Vec3 other = (tree.point(t[2]) - tree.point(t[0])) * tree.scale();
    const Vec3 normal = edge.cross(other).stableNormalized();
    for (const Index v : t) {
      if (const Index crowd = crowds.of(v); crowd != kNoIndex) axes[crowd] += normal;
    }
  }
  std::vector<Across> all;
  all.reserve(axes.size());
  for (const Vec3& axis : axes) all.push_back(directions_across(axis));
  return all;
}

}  // namespace

CornerAngles::CornerAngles(const FaceTree& tree, std::span<const std::uint8_t> proven) {
  const Crowds crowds(tree, proven);
  if (crowds.n_pairs() < kPairsPerFace * tree.n_faces()) return;
  const std::vector<Across> views = look_along_normals(tree, crowds);
  ranges_.resize(tree.n_faces());
  parallel_chunks(ranges_.size(), [&](Chunk chunk) {
    for (std::size_t slot = chunk.begin; slot < chunk.end; ++slot) {
      const Triangle t = tree.triangle(slot);
      for (std::size_t i = 0; i < 3; ++i) {
        const Index crowd = crowds.of(t[i]);
        if (crowd == kNoIndex) continue;
        const Vec3& vertex = tree.point(t[i]);
        ranges_[slot][i] = range_between(views[crowd], tree.point(t[(i + 1) % 3]) - vertex,
                                         tree.point(t[(i + 2) % 3]) - vertex);
      }
    }
  });
}

}  // namespace meshalyzer
