#include "meshalyzer/repair/driver/internal/face_distance.h"

#include "meshalyzer/base/triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace meshalyzer {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// A face cut into this number of pieces need not be measured to the last digit any more.
constexpr std::size_t kPrecisePieces = 8192;
/// A face cut into this number of pieces counts as far. Each trial of a repair asks whether faces
/// are within the bound; how far they are is asked a few times in all.
constexpr std::size_t kMaxPiecesWithin = 8192;
constexpr std::size_t kMaxPiecesHowFar = 65'536;
/// Lines must cut off at least this fraction of a piece.
constexpr double kLeastShare = 0.02;
/// A piece with more corners is divided between two of them.
constexpr std::size_t kManyCorners = 8;
/// A piece whose altitude is at most this fraction of its longest edge is a segment, except for
/// rounding.
constexpr double kSegmentAltitude = 1e-12;
/// A face within this fraction of the distance that need not be told, which is the bound where only
/// that is asked for, will do for the nearest.
constexpr double kNearEnough = 1.0 / 16;
/// Beyond this number of cuts every second one halves a piece across its diameter, so that pieces
/// surely shrink.
constexpr std::uint32_t kFreeCuts = 16;
/// The nearest face to the region at a corner is searched from a point at this fraction of the way
/// to the middle: at the corner itself, often a vertex of both surfaces, it would be any face round
/// it.
constexpr double kInwards = 1.0 / 16;
/// Parts that exceed the largest distance found by less than this fraction of the resolution are
/// not searched further.
constexpr double kAim = 1.0 / 8;

double distance_to(const Corners& t, const Vec3& p) {
  return closest_on_triangle(t, p).distance;
}

/// The corner of a piece that is farthest from a face, and so the farthest of all its points: the
/// distance from a triangle is convex.
struct FarthestCorner {
  Vec3 point;
  double distance = -1.0;
};

FarthestCorner farthest_corner(const ConvexPiece& piece, const Corners& face) {
  FarthestCorner farthest;
  for (const Vec3& corner : piece.corners()) {
    const double distance = distance_to(face, corner);
    if (distance > farthest.distance) farthest = {corner, distance};
  }
  return farthest;
}

}  // namespace

double largest_distance(const Corners& from, const Corners& to) {
  return std::max({distance_to(to, from[0]), distance_to(to, from[1]), distance_to(to, from[2])});
}

FaceDistance SurfaceDistance::measure(const Corners& corners) {
  if (const std::optional<double> within = distance_from_latest(corners)) return {*within, false};
  start_with(corners, ConvexPiece(corners));
  return measure_pieces(nullptr);
}

FaceDistance SurfaceDistance::measure(const Corners& corners, const ConvexPiece& part,
                                      const BoxTree& doubtful) {
  if (const std::optional<double> within = distance_from_latest(corners)) return {*within, false};
  start_with(corners, part);
  return measure_pieces(&doubtful);
}

/// Measures all pieces; those in no box, if boxes are given, are known to be within the bound.
FaceDistance SurfaceDistance::measure_pieces(const BoxTree* doubtful) {
  const std::size_t max_pieces =
      question_ == DistanceQuestion::IsWithin ? kMaxPiecesWithin : kMaxPiecesHowFar;
  double upper_of_all = kInfinity;
  for (std::size_t n_pieces = 1; !work_.empty(); ++n_pieces) {
    const Piece piece = work_.back();
    work_.pop_back();
    if (doubtful != nullptr && !doubtful->meets_any(piece.shape.box())) {
      done_ = bound_;
      continue;
    }
    if (n_pieces > kPrecisePieces) asks_within_ = true;
    const Estimate known = estimate(piece.shape);
    if (n_pieces == 1) upper_of_all = known.upper;
    if (!asks_within_) found_ = std::max(found_, known.lower);
    if (known.upper <= bound_ && is_precise(known)) {
      done_ = std::max(done_, known.upper);
    } else if (known.lower > bound_ || is_precise(known) || n_pieces >= max_pieces) {
      return {upper_of_all, true};
    } else {
      divide(piece, known);
    }
  }
  return {done_, false};
}

/// Makes a part of a triangle the only piece.
void SurfaceDistance::start_with(const Corners& triangle, const ConvexPiece& part) {
  done_ = 0.0;
  asks_within_ = question_ == DistanceQuestion::IsWithin;
  longest_side_ = longest_side(triangle);
  const Vec3 along = (triangle[1] - triangle[0]) / longest_side_;
  const Vec3 other = (triangle[2] - triangle[0]) / longest_side_;
  Vec3 normal = along.cross(other);
  is_segment_ = !(normal.norm() > kSegmentAltitude);
  if (is_segment_) {
    normal = (along.squaredNorm() > other.squaredNorm() ? along : other).unitOrthogonal();
  }
  plane_ = {triangle[0], normal.normalized()};
  work_.assign(1, {part});
}

std::optional<double> SurfaceDistance::distance_from_latest(const Corners& corners) const {
  if (question_ != DistanceQuestion::IsWithin || hint_ == kNoIndex) return std::nullopt;
  const double distance = largest_distance(corners, corners_of(hint_));
  return distance <= bound_ ? std::optional(distance) : std::nullopt;
}

/// Returns the closest point of the surface, or any that is so near that its distance does not
/// matter.
SurfacePoint SurfaceDistance::closest(const Vec3& point) {
  const double near_enough = kNearEnough * (asks_within_ ? bound_ : found_);
  SurfacePoint answer;
  answer.distance = kInfinity;
  answer =
      closest_.find({.point = point, .hint = hint_, .near_enough = near_enough}).value_or(answer);
  hint_ = answer.slot;
  return answer;
}

Corners SurfaceDistance::corners_of(Index slot) const {
  const Triangle& t = tree_.triangle(slot);
  return {tree_.point(t[0]), tree_.point(t[1]), tree_.point(t[2])};
}

/// Tells whether further cuts could not improve the answer.
bool SurfaceDistance::is_precise(const Estimate& known) const {
  if (asks_within_ && known.upper <= bound_) return true;
  const double lower = known.upper > bound_ ? known.lower : std::max(found_, known.lower);
  return known.upper <= lower + slack_;
}

SurfaceDistance::Estimate SurfaceDistance::estimate(const ConvexPiece& piece) {
  const Vec3 middle = piece.middle();
  const SurfacePoint at_middle = closest(middle);
  Estimate known{.lower = at_middle.distance, .upper = kInfinity, .nearest = {}};
  if (at_middle.slot == kNoIndex) return known;
  const FarthestCorner farthest = farthest_corner(piece, corners_of(at_middle.slot));
  known.upper = farthest.distance;
  known.nearest[known.n_nearest++] = {middle, at_middle};
  if (is_precise(known)) return known;
  known.lower = std::max(known.lower, closest(farthest.point).distance);
  const Vec3 inwards = between(farthest.point, middle, kInwards);
  const SurfacePoint near_corner = closest(inwards);
  known.lower = std::max(known.lower, near_corner.distance);
  if (near_corner.slot == at_middle.slot) return known;
  known.upper =
      std::min(known.upper, farthest_corner(piece, corners_of(near_corner.slot)).distance);
  known.nearest[known.n_nearest++] = {inwards, near_corner};
  return known;
}

/// Divides a piece so that as much of it as possible is near enough to one face, and finished; if
/// that is little, halves it.
void SurfaceDistance::divide(const Piece& piece, const Estimate& known) {
  const double level =
      asks_within_ ? bound_ : std::min(bound_, std::max(found_, known.lower) + kAim * slack_);
  const bool is_halving_due = piece.depth >= kFreeCuts && piece.depth % 2 == 1;
  for (std::size_t i = 0; i < known.n_nearest && !is_halving_due; ++i) {
    if (cut_off_near(piece.shape, known.nearest[i], level) < kLeastShare) continue;
    done_ = std::max(done_, level);
    for (const ConvexPiece& part : rest_) keep(part, piece.depth + 1);
    return;
  }
  halve(piece);
}

/// Cuts off a part of a piece that is within a level of a face, and leaves the rest in `rest_`.
/// @return The fraction that was cut off.
double SurfaceDistance::cut_off_near(const ConvexPiece& piece, const Nearest& nearest,
                                     double level) {
  rest_.clear();
  // Rounding must not take the cuts beyond the level.
  const double aim = level - kAim / 4 * slack_;
  if (!(nearest.found.distance < aim)) return 0.0;
  const Corners face = corners_of(nearest.found.slot);
  const std::vector<HalfSpace> bounds =
      find_near_region(face, plane_, aim, {nearest.place, nearest.found.point});
  ConvexPiece near = piece;
  for (const HalfSpace& bound : bounds) {
    ConvexPiece::Parts parts = near.cut(bound);
    if (parts.inside.empty()) return 0.0;
    if (!parts.outside.empty()) rest_.push_back(parts.outside);
    near = parts.inside;
  }
  if (farthest_corner(near, face).distance > level) return 0.0;
  const double whole = size_of(piece);
  return whole > 0.0 ? size_of(near) / whole : 0.0;
}

/// Returns the area of a piece, or the length where the triangle is a segment.
double SurfaceDistance::size_of(const ConvexPiece& piece) const {
  if (!is_segment_) return piece.area(longest_side_);
  const auto [from, to] = piece.diameter();
  return (to - from).stableNorm();
}

/// Cuts a piece in two across its diameter.
void SurfaceDistance::halve(const Piece& piece) {
  const auto [from, to] = piece.shape.diameter();
  const HalfSpace half{between(from, to, 0.5), (to - from).stableNormalized()};
  ConvexPiece::Parts parts = piece.shape.cut(half);
  if (parts.outside.empty()) parts = piece.shape.cut_between_corners();
  keep(parts.outside, piece.depth + 1);
  keep(parts.inside, piece.depth + 1);
}

/// Adds a part to the pieces, in two if it has many corners.
void SurfaceDistance::keep(const ConvexPiece& part, std::uint32_t depth) {
  if (part.corners().size() > kManyCorners) {
    const ConvexPiece::Parts halves = part.cut_between_corners();
    keep(halves.inside, depth);
    keep(halves.outside, depth);
    return;
  }
  work_.push_back({part, depth});
}

}  // namespace meshalyzer
