#include "meshalyzer/repair/holes/internal/large_loop.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/exact/plane_view.h"
#include "meshalyzer/repair/holes/internal/corner_grid.h"
#include "meshalyzer/repair/holes/internal/triangulate_loop.h"

#include <algorithm>
#include <queue>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

/// The factor for the squared chord of a thin ear: it is cut later, but not so late that others
/// grow across the loop meanwhile.
constexpr double kThinFactor = 16.0;

/// The requirements for an ear to be cut; each demands less than the one before.
enum class Demand : std::uint8_t { ConvexAndEmpty, Convex, Nothing };

/// The triangle of a corner and its two neighbours at the time when it was made.
struct Ear {
  /// The squared length of the chord, larger for a thin ear.
  double cost = 0.0;
  Index tip = 0;
  Index before = 0;
  Index after = 0;

  /// Tells whether it is to be cut later than another.
  friend bool operator<(const Ear& a, const Ear& b) {
    return std::tie(a.cost, a.tip) > std::tie(b.cost, b.tip);
  }
};

/// Returns the projection that shows a loop best.
PlaneView choose_view(const std::vector<Vec3>& points) {
  // Positions are relative to one of the points, so that a loop far from the origin keeps its
  // digits.
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    area += normal_of(points[0], points[i], points[i + 1]);
  }
  const Axis axis = longest_axis(area);
  return {axis, area[static_cast<Eigen::Index>(axis)] < 0.0 ? -1 : 1};
}

/// Cuts ears off a loop.
class EarCutter {
 public:
  EarCutter(const LoopPolygon& polygon, const LoopRules& rules)
      : polygon_(polygon),
        rules_(rules),
        view_(choose_view(polygon.points)),
        normals_(polygon.normals),
        n_left_(polygon.size()) {
    const std::size_t n = polygon.size();
    for (Index i = 0; i < n; ++i) {
      before_.push_back(i == 0 ? static_cast<Index>(n - 1) : i - 1);
      after_.push_back(i + 1 < n ? i + 1 : 0);
      const Vec3& p = polygon.points[i];
      const auto axis = static_cast<Eigen::Index>(view_.dropped);
      flat_.emplace_back(p[(axis + 1) % 3], p[(axis + 2) % 3]);
    }
    is_left_.assign(n, 1);
  }

  /// Cuts ears until the given number of corners is left, or none can be cut.
  void run(std::size_t n_wanted) {
    Demand demand = Demand::ConvexAndEmpty;
    while (n_left_ > n_wanted) {
      const std::size_t n_before = n_left_;
      cut_all(demand, n_wanted);
      // Cutting may make ears of corners that were rejected before, but seldom many.
      if (n_before - n_left_ > n_before / 16) continue;
      if (demand == Demand::Nothing) return;
      demand = demand == Demand::ConvexAndEmpty ? Demand::Convex : Demand::Nothing;
    }
  }

  /// Returns the triangles cut so far.
  [[nodiscard]] std::vector<Triangle> take_triangles() { return std::move(triangles_); }

  /// Returns the remaining loop.
  [[nodiscard]] LoopPolygon rest() const {
    LoopPolygon rest{.vertices = {}, .points = {}, .normals = {}, .thin = polygon_.thin};
    for (const Index i : corners_left()) {
      rest.vertices.push_back(polygon_.vertices[i]);
      rest.points.push_back(polygon_.points[i]);
      rest.normals.push_back(normals_[i]);
    }
    return rest;
  }

 private:
  [[nodiscard]] std::vector<Index> corners_left() const {
    std::vector<Index> left;
    for (Index i = 0; i < is_left_.size(); ++i) {
      if (is_left_[i] != 0) left.push_back(i);
    }
    return left;
  }

  /// Cuts ears that meet a requirement, until the given number of corners is left or each has been
  /// examined.
  void cut_all(Demand demand, std::size_t n_wanted) {
    std::vector<Index> left = corners_left();
    std::size_t n_in_grid = left.size();
    CornerGrid grid(flat_, left);
    std::priority_queue<Ear> ears;
    for (const Index i : left) ears.push(ear_at(i));
    while (n_left_ > n_wanted && !ears.empty()) {
      const Ear ear = ears.top();
      ears.pop();
      if (!is_current(ear) || !is_allowed(ear) || !meets(demand, ear, grid)) continue;
      cut(ear);
      ears.push(ear_at(ear.before));
      ears.push(ear_at(ear.after));
      if (n_left_ < n_in_grid / 2) {
        grid = CornerGrid(flat_, corners_left());
        n_in_grid = n_left_;
      }
    }
  }

  [[nodiscard]] Ear ear_at(Index tip) const {
    const Index before = before_[tip];
    const Index after = after_[tip];
    const CandidateTriangle triangle = measure_candidate(
        polygon_.points[before], polygon_.points[tip], polygon_.points[after], polygon_.thin);
    const double chord = (polygon_.points[after] - polygon_.points[before]).squaredNorm();
    return {.cost = triangle.fault == TriangleFault::None ? chord : kThinFactor * chord,
            .tip = tip,
            .before = before,
            .after = after};
  }

  [[nodiscard]] bool is_current(const Ear& ear) const {
    return is_left_[ear.tip] != 0 && before_[ear.tip] == ear.before && after_[ear.tip] == ear.after;
  }

  [[nodiscard]] Triangle corners_of(const Ear& ear) const {
    return {polygon_.vertices[ear.before], polygon_.vertices[ear.tip],
            polygon_.vertices[ear.after]};
  }

  [[nodiscard]] Corners places_of(const Ear& ear) const {
    return {polygon_.points[ear.before], polygon_.points[ear.tip], polygon_.points[ear.after]};
  }

  [[nodiscard]] bool is_allowed(const Ear& ear) const {
    const Triangle t = corners_of(ear);
    return rules_.allows_chord(t[0], t[2]) && rules_.allows_triangle(t);
  }

  [[nodiscard]] bool meets(Demand demand, const Ear& ear, const CornerGrid& grid) const {
    if (demand == Demand::Nothing) return true;
    const Corners t = places_of(ear);
    if (view_.turn(t[0], t[1], t[2]) <= 0) return false;
    return demand == Demand::Convex || is_empty(ear, grid);
  }

  /// Tells whether no other remaining corner lies in the ear.
  [[nodiscard]] bool is_empty(const Ear& ear, const CornerGrid& grid) const {
    const Corners places = places_of(ear);
    Eigen::AlignedBox2d box(flat_[ear.tip]);
    box.extend(flat_[ear.before]).extend(flat_[ear.after]);
    return !grid.any_near({flat_[ear.tip], flat_[ear.before], flat_[ear.after]}, [&](Index i) {
      return is_left_[i] != 0 && box.contains(flat_[i]) && !is_at_corner(ear, i) &&
             view_.covers(places, polygon_.points[i]);
    });
  }

  [[nodiscard]] bool is_at_corner(const Ear& ear, Index i) const {
    return flat_[i] == flat_[ear.tip] || flat_[i] == flat_[ear.before] ||
           flat_[i] == flat_[ear.after];
  }

  void cut(const Ear& ear) {
    triangles_.push_back(corners_of(ear));
    after_[ear.before] = ear.after;
    before_[ear.after] = ear.before;
    is_left_[ear.tip] = 0;
    --n_left_;
    normals_[ear.before] = measure_candidate(polygon_.points[ear.before], polygon_.points[ear.tip],
                                             polygon_.points[ear.after], polygon_.thin)
                               .normal;
  }

  const LoopPolygon& polygon_;
  const LoopRules& rules_;
  PlaneView view_;
  /// Indexed by corner: the normal of the face beyond the edge to the next remaining corner.
  std::vector<Vec3> normals_;
  std::size_t n_left_;
  std::vector<Index> before_;
  std::vector<Index> after_;
  std::vector<CornerGrid::Point> flat_;
  std::vector<std::uint8_t> is_left_;
  std::vector<Triangle> triangles_;
};

}  // namespace

std::optional<std::vector<Triangle>> triangulate_large_loop(const LoopPolygon& polygon,
                                                            const LoopRules& rules) {
  const std::size_t n_rest = rules.weight == LoopWeight::Flat ? 3 : kSmallLoop;
  if (polygon.size() <= n_rest) return triangulate_loop(polygon, rules);
  EarCutter cutter(polygon, rules);
  cutter.run(n_rest);
  const LoopPolygon rest = cutter.rest();
  if (rest.size() > n_rest) return std::nullopt;
  const auto last = triangulate_loop(rest, rules);
  if (!last) return std::nullopt;
  std::vector<Triangle> triangles = cutter.take_triangles();
  triangles.insert(triangles.end(), last->begin(), last->end());
  return triangles;
}

}  // namespace meshalyzer
