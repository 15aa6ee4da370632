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
constexpr std::size_t kPrecisePieces = 2048;
/// A face cut into this number of pieces counts as far. Each trial of a repair asks whether faces
/// are within the bound; how far they are is asked a few times in all.
constexpr std::size_t kMaxPiecesWithin = 8192;
constexpr std::size_t kMaxPiecesHowFar = 65'536;
/// A line must cut off at least this fraction of a piece; an edge must be divided at least this
/// evenly at the change of the nearest face, or is halved.
constexpr double kLeastShare = 0.02;
constexpr double kLeastEvenness = 0.3;
/// A piece whose altitude is at most this fraction of its longest edge is a segment, except for
/// rounding.
constexpr double kSegmentAltitude = 1e-12;
/// Where only the bound is asked for, a face within this fraction of it will do for the nearest.
constexpr double kNearEnough = 1.0 / 16;
/// Beyond this number of cuts every second one halves the longest edge, so that pieces surely
/// shrink.
constexpr std::uint32_t kFreeCuts = 16;
/// The nearest face to the region at a corner is searched from a point at this fraction of the way
/// to the middle: at the corner itself, often a vertex of both surfaces, it would be any face round
/// it.
constexpr double kInwards = 1.0 / 16;
/// Parts that exceed the largest distance found by less than this fraction of the resolution are
/// not searched further.
constexpr double kAim = 1.0 / 8;
/// The maximum number of steps towards the point where an edge leaves the neighbourhood of a face.
constexpr int kMaxEdgeSteps = 24;

/// Returns the length without overflow or underflow of squares.
double length(const Vec3& v) {
  return std::hypot(v.x(), v.y(), v.z());
}

/// Returns a point between two others, without overflow.
Vec3 between(const Vec3& a, const Vec3& b, double at) {
  return (1.0 - at) * a + at * b;
}

/// Tells whether a triangle is a segment, except for rounding.
bool is_segment(const Corners& t) {
  const double longest = longest_side(t);
  const Vec3 normal = ((t[1] - t[0]) / longest).cross((t[2] - t[0]) / longest);
  return length(normal) <= kSegmentAltitude;
}

double distance_to(const Corners& t, const Vec3& p) {
  return closest_on_triangle(t, p).distance;
}

std::array<double, 3> corner_distances(const Corners& from, const Corners& to) {
  return {distance_to(to, from[0]), distance_to(to, from[1]), distance_to(to, from[2])};
}

/// Returns the parameter up to which a segment is near enough to a face, if its begin is and its
/// end is not: the distance there is at most `level`, and not much less than `target`. The begin
/// has parameter 0.
///
/// Uses Newton's method from the far end: as the distance is convex, it passes no solution.
double find_exit(const Corners& face, const std::array<Vec3, 2>& segment,
                 const std::array<double, 2>& target_and_level) {
  const auto [target, level] = target_and_level;
  double at = 1.0;
  for (int step = 0; step < kMaxEdgeSteps; ++step) {
    const Vec3 point = between(segment[0], segment[1], at);
    const TrianglePoint foot = closest_on_triangle(face, point);
    if (foot.distance <= level) return at;
    const double slope = (point - foot.point).dot(segment[1] - segment[0]) / foot.distance;
    const double next = at - (foot.distance - target) / slope;
    // This fails if the distance grows as slowly as rounding errors, or overflows.
    if (!(next > 0.0 && next < at)) break;
    at = next;
  }
  return 0.0;
}

}  // namespace

double largest_distance(const Corners& from, const Corners& to) {
  const auto distances = corner_distances(from, to);
  return *std::max_element(distances.begin(), distances.end());
}

FaceDistance SurfaceDistance::measure(const Corners& corners, const BoxTree* doubtful) {
  const auto is_known = [&](const Corners& t) {
    return doubtful != nullptr && !doubtful->meets_any(box_of(t));
  };
  done_ = 0.0;
  asks_within_ = question_ == DistanceQuestion::IsWithin;
  if (const std::optional<double> within = distance_from_latest(corners)) return {*within, false};
  if (is_known(corners)) return {bound_, false};
  work_.assign(1, {corners, {}, 0});
  for (std::size_t i = 0; i < 3; ++i) work_.front().distances[i] = closest(corners[i]).distance;
  const std::size_t max_pieces =
      question_ == DistanceQuestion::IsWithin ? kMaxPiecesWithin : kMaxPiecesHowFar;
  double upper_of_all = kInfinity;
  for (std::size_t n_pieces = 1; !work_.empty(); ++n_pieces) {
    const Piece piece = work_.back();
    work_.pop_back();
    // The first piece is the whole triangle, which was looked up above.
    if (n_pieces > 1 && is_known(piece.corners)) {
      done_ = bound_;
      continue;
    }
    if (n_pieces > kPrecisePieces) asks_within_ = true;
    const Estimate known = estimate(piece);
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

std::optional<double> SurfaceDistance::distance_from_latest(const Corners& corners) const {
  if (!asks_within_ || hint_ == kNoIndex) return std::nullopt;
  const double distance = largest_distance(corners, corners_of(hint_));
  return distance <= bound_ ? std::optional(distance) : std::nullopt;
}

/// Returns the closest point of the surface; where only the bound is asked for, any that is near
/// enough.
SurfacePoint SurfaceDistance::closest(const Vec3& point) {
  const double near_enough = asks_within_ ? kNearEnough * bound_ : 0.0;
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

SurfaceDistance::Estimate SurfaceDistance::estimate(const Piece& piece) {
  const Corners& t = piece.corners;
  const auto& d = piece.distances;
  const Vec3 middle = centroid_without_overflow(t);
  const SurfacePoint at_middle = closest(middle);
  Estimate known;
  known.lower = std::max({d[0], d[1], d[2], at_middle.distance});
  known.upper = at_middle.distance +
                std::max({length(t[0] - middle), length(t[1] - middle), length(t[2] - middle)});
  add_candidate(piece, at_middle.slot, known);
  for (std::size_t i = 0; i < 3 && !is_precise(known); ++i) {
    const SurfacePoint near_corner = closest(between(t[i], middle, kInwards));
    known.lower = std::max(known.lower, near_corner.distance);
    add_candidate(piece, near_corner.slot, known);
  }
  return known;
}

void SurfaceDistance::add_candidate(const Piece& piece, Index slot, Estimate& known) const {
  const std::span known_ones = std::span(known.candidates).first(known.n_candidates);
  const bool is_known = std::any_of(known_ones.begin(), known_ones.end(),
                                    [&](const Candidate& other) { return other.slot == slot; });
  if (slot == kNoIndex || is_known) return;
  const auto distances = corner_distances(piece.corners, corners_of(slot));
  known.candidates[known.n_candidates++] = {slot, distances};
  known.upper = std::min(known.upper, *std::max_element(distances.begin(), distances.end()));
}

/// Divides a piece so that as much of it as possible is near enough to one face, and finished; if
/// that is little, divides it at the middle of its longest edge.
void SurfaceDistance::divide(const Piece& piece, const Estimate& known) {
  const double level =
      asks_within_ ? bound_ : std::min(bound_, std::max(found_, known.lower) + kAim * slack_);
  if (is_segment(piece.corners)) return divide_segment(piece, known, level);
  Clip best;
  Cut cut = halve_longest_edge(piece.corners);
  double evenness = kLeastEvenness;
  const bool is_halving_due = piece.depth >= kFreeCuts && piece.depth % 2 == 1;
  for (std::size_t i = 0; i < known.n_candidates; ++i) {
    const Clip clip = clip_for(piece, known.candidates[i], level);
    if (clip.share > best.share) best = clip;
    for (std::size_t k = 0; k < 2 && clip.is_apex_done && !is_halving_due; ++k) {
      if (std::min(clip.at[k], 1.0 - clip.at[k]) > evenness) {
        evenness = std::min(clip.at[k], 1.0 - clip.at[k]);
        cut = {clip.apex, (clip.apex + 1 + k) % 3, clip.at[k]};
      }
    }
  }
  if (best.share >= kLeastShare) {
    done_ = std::max(done_, level);
    keep_remainder(piece, best);
  } else {
    cut_in_two(piece, cut);
  }
}

/// Divides a segment where it leaves the neighbourhood of a face, or at its middle. A line across
/// it would cut off a share of no area, and leave a piece as long as before.
void SurfaceDistance::divide_segment(const Piece& piece, const Estimate& known, double level) {
  const Cut middle = halve_longest_edge(piece.corners);
  Cut exit{.at = 0.0};
  for (std::size_t i = 0; i < known.n_candidates; ++i) {
    const Candidate& face = known.candidates[i];
    for (const auto& [near, far] :
         {std::pair(middle.from, middle.to), std::pair(middle.to, middle.from)}) {
      if (face.distances[near] > level || face.distances[far] <= level) continue;
      const double at = exit_at(face.slot, {piece.corners[near], piece.corners[far]}, level);
      if (at > exit.at) exit = {near, far, at};
    }
  }
  const bool is_begin_done = exit.at >= kLeastShare;
  const Cut& cut = is_begin_done ? exit : middle;
  const Vec3 point = between(piece.corners[cut.from], piece.corners[cut.to], cut.at);
  const double distance = closest(point).distance;
  const auto keep_from = [&](std::size_t end) {
    const double at_end = piece.distances[end];
    work_.push_back({{piece.corners[end], point, point}, {at_end, distance, distance}, 0});
  };
  keep_from(cut.to);
  if (is_begin_done) {
    done_ = std::max(done_, level);
  } else {
    keep_from(cut.from);
  }
}

/// Returns the parameter up to which a segment is within the level of a face, see find_exit().
double SurfaceDistance::exit_at(Index slot, const std::array<Vec3, 2>& segment,
                                double level) const {
  return find_exit(corners_of(slot), segment, {level - kAim / 4 * slack_, level});
}

/// Finds the line that separates the corners near enough to the face from the others; the corner
/// that is alone on its side is the apex. The fraction is 0 if all corners are on one side.
SurfaceDistance::Clip SurfaceDistance::clip_for(const Piece& piece, const Candidate& face,
                                                double level) const {
  const auto is_near = [&](std::size_t i) { return face.distances[i] <= level; };
  for (std::size_t apex = 0; apex < 3; ++apex) {
    const std::array<std::size_t, 2> others{(apex + 1) % 3, (apex + 2) % 3};
    if (is_near(apex) == is_near(others[0]) || is_near(apex) == is_near(others[1])) continue;
    Clip clip{.apex = apex, .at = {}, .is_apex_done = is_near(apex), .share = 0.0};
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t from = clip.is_apex_done ? apex : others[k];
      const std::size_t to = clip.is_apex_done ? others[k] : apex;
      const double exit = exit_at(face.slot, {piece.corners[from], piece.corners[to]}, level);
      clip.at[k] = clip.is_apex_done ? exit : 1.0 - exit;
    }
    const double at_apex = clip.at[0] * clip.at[1];
    clip.share = clip.is_apex_done ? at_apex : 1.0 - at_apex;
    return clip;
  }
  return {};
}

/// Continues with the part that is not near enough.
void SurfaceDistance::keep_remainder(const Piece& piece, const Clip& clip) {
  const std::size_t next = (clip.apex + 1) % 3;
  const std::size_t last = (clip.apex + 2) % 3;
  const Vec3& apex = piece.corners[clip.apex];
  const Vec3 p = between(apex, piece.corners[next], clip.at[0]);
  const Vec3 q = between(apex, piece.corners[last], clip.at[1]);
  const double at_p = closest(p).distance;
  const double at_q = closest(q).distance;
  const std::uint32_t depth = piece.depth + 1;
  if (!clip.is_apex_done) {
    work_.push_back({{apex, p, q}, {piece.distances[clip.apex], at_p, at_q}, depth});
    return;
  }
  const double at_next = piece.distances[next];
  const double at_last = piece.distances[last];
  work_.push_back({{p, piece.corners[next], piece.corners[last]}, {at_p, at_next, at_last}, depth});
  work_.push_back({{p, piece.corners[last], q}, {at_p, at_last, at_q}, depth});
}

void SurfaceDistance::cut_in_two(const Piece& piece, const Cut& where) {
  const Vec3 point = between(piece.corners[where.from], piece.corners[where.to], where.at);
  const double distance = closest(point).distance;
  for (const std::size_t replaced : {where.from, where.to}) {
    Piece part = piece;
    part.corners[replaced] = point;
    part.distances[replaced] = distance;
    ++part.depth;
    work_.push_back(part);
  }
}

SurfaceDistance::Cut SurfaceDistance::halve_longest_edge(const Corners& t) {
  Cut longest;
  double longest_so_far = -1.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (const double l = length(t[next] - t[i]); l > longest_so_far) {
      longest_so_far = l;
      longest = {i, next, 0.5};
    }
  }
  return longest;
}

}  // namespace meshalyzer
