#include "meshalyzer/repair/split/internal/pair_round_edge.h"

#include "meshalyzer/repair/split/internal/faces_by_angle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Among more faces than this no costs are compared, because that takes at least quadratic time.
constexpr std::size_t kMaxWeighed = 32;

/// The cost of an open component, relative to that of a fold by half a turn.
constexpr double kOpenPenalty = 2.0;

/// Two faces that might be joined, by their indices in the order, and the cost of joining them.
struct Candidate {
  bool is_other_component = false;
  double cost = 0.0;
  /// The number of places from one to the other: of faces at the same angles the inner ones come
  /// first.
  std::size_t span = 0;
  std::size_t first = 0;
  std::size_t second = 0;

  [[nodiscard]] auto key() const { return std::tie(is_other_component, cost, span, first, second); }
};

/// The pairing of one edge, as it grows.
class EdgeMatcher {
 public:
  EdgeMatcher(std::span<const FaceAtEdge> faces, FacesByAngle by_angle)
      : faces_(faces), by_angle_(std::move(by_angle)), partner_(faces.size(), kNoIndex) {}

  [[nodiscard]] EdgePairing match() {
    const bool alternates = orientations_alternate();
    if (alternates || faces_.size() > kMaxWeighed) {
      match_nested();
    } else {
      match_opposite();
      match_alike();
      match_without_angle();
    }
    return {.partner = std::move(partner_), .alternates = alternates};
  }

 private:
  [[nodiscard]] std::size_t n_places() const { return by_angle_.order.size(); }
  [[nodiscard]] Index face_at(std::size_t place) const { return by_angle_.order[place].face; }
  [[nodiscard]] Crossing crossing_at(std::size_t place) const {
    return faces_[face_at(place)].crossing;
  }

  [[nodiscard]] bool orientations_alternate() const {
    if (!by_angle_.without_angle.empty() || n_places() % 2 != 0) return false;
    for (std::size_t i = 0; i < n_places(); ++i) {
      if (crossing_at(i) == crossing_at((i + 1) % n_places())) return false;
    }
    return true;
  }

  void join(std::size_t first, std::size_t second) { join_faces(face_at(first), face_at(second)); }
  void join_faces(Index i, Index j) {
    partner_[i] = j;
    partner_[j] = i;
  }

  /// Joins each face that ends material to the last unjoined one before it that began some.
  void match_nested() {
    std::vector<std::size_t> open;
    for (std::size_t turn = 0; turn < 2; ++turn) {
      for (std::size_t i = 0; i < n_places(); ++i) {
        if (crossing_at(i) == Crossing::Against) {
          if (turn == 0) open.push_back(i);
        } else if (partner_[face_at(i)] == kNoIndex && !open.empty()) {
          join(open.back(), i);
          open.pop_back();
        }
      }
    }
  }

  /// Returns the places of unjoined faces, by runs of equal crossing; the last run and the first
  /// are merged if they can be.
  [[nodiscard]] std::vector<std::vector<std::size_t>> runs() const {
    std::vector<std::vector<std::size_t>> runs;
    for (std::size_t i = 0; i < n_places(); ++i) {
      if (partner_[face_at(i)] != kNoIndex) continue;
      if (runs.empty() || crossing_at(runs.back().front()) != crossing_at(i)) runs.emplace_back();
      runs.back().push_back(i);
    }
    if (runs.size() > 2 && runs.size() % 2 == 1) {
      runs.front().insert(runs.front().begin(), runs.back().begin(), runs.back().end());
      runs.pop_back();
    }
    return runs;
  }

  /// Repeatedly joins one face of each run that begins material to one of the run behind it.
  void match_opposite() {
    bool goes_on = true;
    while (goes_on) {
      goes_on = false;
      const auto free = runs();
      if (free.size() < 2) return;
      const bool one_is_odd = n_free(free) % 2 != 0;
      for (std::size_t r = 0; r < free.size(); ++r) {
        if (crossing_at(free[r].front()) != Crossing::Against) continue;
        goes_on |= join_best(free[r], free[(r + 1) % free.size()], one_is_odd);
      }
    }
  }

  [[nodiscard]] static std::size_t n_free(const std::vector<std::vector<std::size_t>>& runs) {
    std::size_t n = 0;
    for (const auto& run : runs) n += run.size();
    return n;
  }

  bool join_best(const std::vector<std::size_t>& begins, const std::vector<std::size_t>& ends,
                 bool one_is_odd) {
    std::vector<Candidate> candidates;
    for (const std::size_t i : begins) {
      for (const std::size_t j : ends) {
        const double inside = angle_between(i, j);
        candidates.push_back(
            candidate(i, j, one_is_odd ? std::abs(inside - std::numbers::pi) : inside));
        if (!one_is_odd) candidates.back().is_other_component = false;
      }
    }
    return join_cheapest(candidates);
  }

  /// Joins faces with the same orientation, which makes flipped edges.
  void match_alike() {
    bool goes_on = true;
    while (goes_on) {
      std::vector<Candidate> candidates;
      for (std::size_t i = 0; i < n_places(); ++i) {
        for (std::size_t j = i + 1; j < n_places(); ++j) {
          if (partner_[face_at(i)] != kNoIndex || partner_[face_at(j)] != kNoIndex) continue;
          candidates.push_back(candidate(i, j, std::abs(angle_between(i, j) - std::numbers::pi)));
        }
      }
      goes_on = join_cheapest(candidates);
    }
  }

  /// Joins faces of zero area to each other or to remaining ones: of the same component first, then
  /// those with opposite orientations.
  void match_without_angle() {
    for (const Index i : by_angle_.without_angle) {
      if (partner_[i] != kNoIndex) continue;
      Index best = kNoIndex;
      const auto key = [&](Index j) {
        return std::tuple(!same_component(i, j), faces_[i].crossing == faces_[j].crossing, j);
      };
      for (Index j = 0; j < faces_.size(); ++j) {
        if (j == i || partner_[j] != kNoIndex) continue;
        if (best == kNoIndex || key(j) < key(best)) best = j;
      }
      if (best != kNoIndex) join_faces(i, best);
    }
  }

  [[nodiscard]] bool same_component(Index i, Index j) const {
    return faces_[i].component != kNoIndex && faces_[i].component == faces_[j].component;
  }

  /// Returns the counter-clockwise angle from one place to another, 0 to 2 pi.
  [[nodiscard]] double angle_between(std::size_t from, std::size_t to) const {
    const double turn = by_angle_.order[to].angle - by_angle_.order[from].angle;
    return from < to ? turn : turn + 2 * std::numbers::pi;
  }

  [[nodiscard]] Candidate candidate(std::size_t i, std::size_t j, double turn) const {
    const double border_share = faces_[face_at(i)].border_share + faces_[face_at(j)].border_share;
    return {.is_other_component = !same_component(face_at(i), face_at(j)),
            .cost = turn / std::numbers::pi + kOpenPenalty * border_share,
            .span = (j + n_places() - i) % n_places(),
            .first = i,
            .second = j};
  }

  /// Joins the best of these pairs that passes through no joined pair; returns whether there was
  /// one.
  bool join_cheapest(std::vector<Candidate>& candidates) {
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& p, const Candidate& q) { return p.key() < q.key(); });
    for (const Candidate& c : candidates) {
      if (passes_through_others(c.first, c.second)) continue;
      join(c.first, c.second);
      return true;
    }
    return false;
  }

  [[nodiscard]] bool passes_through_others(std::size_t i, std::size_t j) const {
    const auto [low, high] = std::minmax(i, j);
    std::vector<std::uint8_t> is_between(faces_.size(), 0);
    for (std::size_t k = low + 1; k < high; ++k) is_between[face_at(k)] = 1;
    for (std::size_t k = low + 1; k < high; ++k) {
      const Index other = partner_[face_at(k)];
      if (other != kNoIndex && is_between[other] == 0) return true;
    }
    return false;
  }

  std::span<const FaceAtEdge> faces_;
  FacesByAngle by_angle_;
  std::vector<Index> partner_;
};

}  // namespace

EdgePairing pair_round_edge(const Vec3& a, const Vec3& b, std::span<const FaceAtEdge> faces) {
  return EdgeMatcher(faces, sort_by_angle(a, b, faces)).match();
}

}  // namespace meshalyzer
