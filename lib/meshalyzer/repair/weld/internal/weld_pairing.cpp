#include "meshalyzer/repair/weld/internal/weld_pairing.h"

#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/repair/split/internal/pair_round_edge.h"
#include "meshalyzer/spatial/triangle_distance.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

constexpr std::string_view kSameVertices =
    "joining them would make two faces with the same vertices";

/// Tells whether two faces at an edge lie on the same side of it in one plane.
bool lie_on_each_other(const Soup& soup, const WeldEdge& a, const WeldEdge& b) {
  const Vec3& p = soup.positions[a.from];
  const Vec3& q = soup.positions[a.to];
  const Vec3& third = soup.positions[a.third];
  const Vec3& other = soup.positions[b.third];
  const std::optional<Axis> axis = projection_axis(p, q, third);
  if (!axis || orient3d(p, q, third, other) != 0) return false;
  return orient2d(*axis, p, q, other) == orient2d(*axis, p, q, third);
}

Pairing pair_two(const Soup& soup, std::span<const WeldEdge> edges,
                 std::span<const EdgeAtPlace> at_place) {
  const WeldEdge& a = edges[at_place[0].edge];
  const WeldEdge& b = edges[at_place[1].edge];
  const EdgeRun run = at_place[1].run;
  if (soup.positions[a.third] == soup.positions[b.third]) {
    return {.joins = {}, .refusal = kSameVertices};
  }
  if (run == EdgeRun::Same && lie_on_each_other(soup, a, b)) {
    return {.joins = {}, .refusal = "the faces lie on each other"};
  }
  return {.joins = {{.first = at_place[0].edge, .second = at_place[1].edge, .run = run}},
          .refusal = {}};
}

/// Pairs more than two edges, by the angles of their faces.
class AnglePairing {
 public:
  AnglePairing(const Soup& soup, std::span<const WeldEdge> edges,
               std::span<const EdgeAtPlace> at_place)
      : edges_(edges), positions_(soup.positions), at_place_(without_repeated(at_place)) {}

  [[nodiscard]] Pairing pair(double reach) const {
    if (has_flat_face()) return {.joins = {}, .refusal = "a face of zero area is among them"};
    const EdgePairing round = pair_round_edge(start(), end(), faces());
    if (!round.alternates) {
      return {.joins = {},
              .refusal =
                  "several edges are there, and the faces do not tell which "
                  "of them belong together"};
    }
    Pairing pairing;
    for (Index i = 0; i < round.partner.size(); ++i) {
      const Index j = round.partner[i];
      if (j < i) continue;
      if (apex(i) == apex(j)) {
        pairing.refusal = kSameVertices;
        continue;
      }
      if (lie_within_reach(i, j, reach)) {
        return {.joins = {},
                .refusal = "several edges are there, and faces that lie on each other"};
      }
      pairing.joins.push_back({.first = at_place_[i].edge, .second = at_place_[j].edge});
    }
    return pairing;
  }

 private:
  [[nodiscard]] const WeldEdge& edge(std::size_t i) const { return edges_[at_place_[i].edge]; }
  [[nodiscard]] const Vec3& apex(std::size_t i) const { return positions_[edge(i).third]; }
  // Edges that are near each other but not at one position are all treated as if they were at the
  // first.
  [[nodiscard]] const Vec3& start() const { return positions_[edge(0).from]; }
  [[nodiscard]] const Vec3& end() const { return positions_[edge(0).to]; }

  /// Keeps only the lowest of faces with the same corners and direction.
  [[nodiscard]] std::vector<EdgeAtPlace> without_repeated(
      std::span<const EdgeAtPlace> at_place) const {
    const auto key = [&](const EdgeAtPlace& e) {
      const Vec3& p = positions_[edges_[e.edge].third];
      return std::tuple(p.x(), p.y(), p.z(), e.run);
    };
    std::vector<EdgeAtPlace> kept(at_place.begin(), at_place.end());
    std::sort(kept.begin(), kept.end(), [&](const EdgeAtPlace& a, const EdgeAtPlace& b) {
      return std::pair(key(a), a.edge) < std::pair(key(b), b.edge);
    });
    const auto repeats = [&](const EdgeAtPlace& a, const EdgeAtPlace& b) {
      return key(a) == key(b);
    };
    kept.erase(std::unique(kept.begin(), kept.end(), repeats), kept.end());
    std::sort(kept.begin(), kept.end(),
              [](const EdgeAtPlace& a, const EdgeAtPlace& b) { return a.edge < b.edge; });
    return kept;
  }

  [[nodiscard]] bool has_flat_face() const {
    for (std::size_t i = 0; i < at_place_.size(); ++i) {
      if (are_collinear(start(), end(), apex(i))) return true;
    }
    return false;
  }

  [[nodiscard]] std::vector<FaceAtEdge> faces() const {
    std::vector<FaceAtEdge> faces;
    for (std::size_t i = 0; i < at_place_.size(); ++i) {
      const bool is_along = at_place_[i].run == EdgeRun::Same;
      faces.push_back(
          {.apex = apex(i), .crossing = is_along ? Crossing::Along : Crossing::Against});
    }
    return faces;
  }

  [[nodiscard]] bool lie_within_reach(std::size_t i, std::size_t j, double reach) const {
    if (reach == 0.0) return false;
    return distance(apex(i), j) <= reach || distance(apex(j), i) <= reach;
  }

  [[nodiscard]] double distance(const Vec3& point, std::size_t i) const {
    const Corners corners{positions_[edge(i).from], positions_[edge(i).to], apex(i)};
    return closest_on_triangle(corners, point).distance;
  }

  std::span<const WeldEdge> edges_;
  std::span<const Vec3> positions_;
  /// The edges in ascending order; the first is the lowest, which is never a repeated one.
  std::vector<EdgeAtPlace> at_place_;
};

}  // namespace

Pairing pair_edges_at_place(const Soup& soup, std::span<const WeldEdge> edges,
                            std::span<const EdgeAtPlace> at_place, double reach) {
  if (at_place.size() == 2) return pair_two(soup, edges, at_place);
  return AnglePairing(soup, edges, at_place).pair(reach);
}

}  // namespace meshalyzer
