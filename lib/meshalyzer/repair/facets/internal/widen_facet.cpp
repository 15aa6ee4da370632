#include "meshalyzer/repair/facets/internal/widen_facet.h"

#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/repair/facets/internal/face_changes.h"
#include "meshalyzer/repair/facets/internal/facet_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The altitudes of a widened face that are tried, as multiples of the tolerance: a larger one may
/// widen its neighbours, too.
constexpr std::array<double, 3> kWidths{1.001, 2.002, 3.003};
/// No vertex moves by more than this multiple of the tolerance.
constexpr double kLongestMove = 4.0;

class Widening {
 public:
  Widening(const WorkingMesh& mesh, const MendRules& rules, Index face, TurningOver turning)
      : mesh_(mesh), rules_(rules), face_(face), turning_(turning) {
    const Triangle& t = mesh.triangle(face);
    const std::size_t longest = measure_facet(mesh.corners(t)).longest_edge();
    for (std::size_t k = 0; k < 3; ++k) ends_and_apex_[k] = t[(longest + k) % 3];
    const Vec3 along = place(1) - place(0);
    length_ = along.stableNorm();
    along_ = along / length_;
    share_ = std::clamp(along_.dot(place(2) - place(0)) / length_, 0.0, 1.0);
  }

  [[nodiscard]] MendAttempt run() const {
    MendAttempt best{.outcome = MendOutcome::Hopeless};
    if (!(rules_.tolerance() > 0.0) || !std::isfinite(length_)) return best;
    std::vector<MendStep::Move> moves = this->moves();
    std::stable_sort(moves.begin(), moves.end(),
                     [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    for (const MendStep::Move& move : moves) {
      best = better(best, attempt(move));
      if (best.is_possible()) break;
    }
    return best;
  }

 private:
  [[nodiscard]] const Vec3& place(std::size_t corner) const {
    return mesh_.position(ends_and_apex_.at(corner));
  }

  [[nodiscard]] double distance(const MendStep::Move& move) const {
    return (move.to - mesh_.position(move.vertex)).stableNorm();
  }

  /// Returns the part of a vector across the longest edge.
  [[nodiscard]] Vec3 across(const Vec3& vector) const {
    return vector - along_ * along_.dot(vector);
  }

  /// Returns the directions in which the apex may move: across the longest edge, away from it and
  /// in the planes of the neighbours; and between the sides of the apex and the farther end of the
  /// edge, where it lies near a corner.
  [[nodiscard]] std::vector<Vec3> directions() const {
    std::vector<Vec3> result;
    const auto add = [&](const Vec3& direction) {
      const double norm = direction.stableNorm();
      if (norm > 0.0 && std::isfinite(norm)) result.push_back(direction / norm);
    };
    const Vec3 to_farther_end = share_ < 0.5 ? along_ : Vec3(-along_);
    add(across(place(2) - place(0)));
    for (std::size_t k = 0; k < 3; ++k) {
      for (const Index v : tips_across(k)) {
        const Vec3 to_tip = mesh_.position(v) - place(2);
        add(k == 0 ? Vec3(-across(to_tip)) : across(to_tip));
        if (k != 0) add(to_tip / to_tip.stableNorm() + to_farther_end);
      }
    }
    return result;
  }

  /// Returns the opposite corners of the other faces at an edge.
  [[nodiscard]] std::vector<Index> tips_across(std::size_t edge) const {
    const Index from = ends_and_apex_.at(edge);
    const Index to = ends_and_apex_.at((edge + 1) % 3);
    std::vector<Index> tips;
    for (const Index f : mesh_.faces_at(from, to)) {
      if (f == face_) continue;
      tips.push_back(third_corner(mesh_.triangle(f), from, to));
    }
    return tips;
  }

  /// Moves the apex, or an end of the edge in the opposite direction.
  [[nodiscard]] std::vector<MendStep::Move> moves() const {
    std::vector<MendStep::Move> result;
    for (const Vec3& direction : directions()) {
      for (const double width : kWidths) add_moves(direction, width * rules_.tolerance(), result);
    }
    return result;
  }

  void add_moves(const Vec3& direction, double width, std::vector<MendStep::Move>& moves) const {
    // After a move by x in the direction, the height is as long as the width: a quadratic equation
    // for x.
    const Vec3 height = across(place(2) - place(0));
    const Vec3 gain = across(direction);
    const double slope = height.dot(gain);
    const double square =
        slope * slope - gain.squaredNorm() * (height.squaredNorm() - width * width);
    if (!(square >= 0.0)) return;
    const double move = (std::sqrt(square) - slope) / gain.squaredNorm();
    if (!(move > 0.0 && move <= kLongestMove * rules_.tolerance())) return;
    moves.push_back({ends_and_apex_[2], place(2) + direction * move});
    for (std::size_t end = 0; end < 2; ++end) {
      const double lever = end == 0 ? 1.0 - share_ : share_;
      if (!(move <= lever * kLongestMove * rules_.tolerance())) continue;
      moves.push_back({ends_and_apex_.at(end), place(end) - direction * (move / lever)});
    }
  }

  [[nodiscard]] MendAttempt attempt(const MendStep::Move& move) const {
    const double moved = distance(move);
    if (rules_.is_fixed(mesh_, move.vertex)) return {.outcome = MendOutcome::Fixed};
    const auto round = mesh_.faces_at(move.vertex);
    if (round.size() > kMostFacesRoundVertex) return {};
    if (!(moved <= rules_.max_deviation())) return {.outcome = MendOutcome::TooFar};
    MendStep step;
    step.moved = move;
    std::vector<FaceChange> faces;
    for (const Index f : round) {
      faces.push_back(change_of_face(mesh_, step, f, mesh_.triangle(f)));
      if (f == face_ && !measure_facet(faces.back().after).is_sound(rules_.tolerance())) return {};
    }
    const MendOutcome outcome = check_shapes(mesh_, faces, 0, rules_.tolerance(), turning_);
    if (outcome != MendOutcome::Possible) return {.outcome = outcome};
    if (rules_.forbids(step)) return {.outcome = MendOutcome::Intersects};
    return {outcome, std::move(step), moved};
  }

  const WorkingMesh& mesh_;
  const MendRules& rules_;
  Index face_;
  TurningOver turning_;
  /// The ends of the longest edge, and the corner opposite to it.
  Triangle ends_and_apex_{};
  double length_ = 0.0;
  /// The unit vector along the longest edge.
  Vec3 along_ = Vec3::Zero();
  /// The place of the apex along the edge, from 0 to 1.
  double share_ = 0.0;
};

}  // namespace

MendAttempt widen_facet(const WorkingMesh& mesh, const MendRules& rules, Index face,
                        TurningOver turning) {
  return Widening(mesh, rules, face, turning).run();
}

}  // namespace meshalyzer
