#include "meshalyzer/contour/bisection_grid.h"

#include "meshalyzer/base/error.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace meshalyzer {
namespace {

/// Origins are whole multiples of this many steps: cells of 1/256 of the cube.
constexpr double kOriginSteps = BisectionGrid::kSize / 256.0;
/// The largest coordinate in steps: points on edges are whole multiples of 1/256 of a step, which
/// must not be rounded.
constexpr double kMostSteps = 0x1p44;

/// The number of tetrahedra that the cube consists of.
constexpr Index kRoots = 6;

/// Returns the number of the corner that is the second end of the bisected edge; the first is
/// corner 0.
std::size_t second_end(const GridTetrahedron& t) {
  return 3 - t.level % 3;
}

LatticePoint middle(const GridTetrahedron& t) {
  const LatticePoint& a = t.corners[0];
  const LatticePoint& b = t.corners[second_end(t)];
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// Returns the two halves of a tetrahedron; the first holds its corner 0.
std::array<GridTetrahedron, 2> halves_of(const GridTetrahedron& t) {
  const std::size_t k = second_end(t);
  GridTetrahedron first{t.corners, t.level + 1};
  GridTetrahedron second{t.corners, t.level + 1};
  std::copy_n(t.corners.begin() + 1, k, second.corners.begin());
  first.corners[k] = middle(t);
  second.corners[k] = middle(t);
  return {first, second};
}

/// Returns the six tetrahedra of the cube, one for each order in which a path along its edges takes
/// the axes.
std::array<GridTetrahedron, kRoots> roots() {
  std::array<GridTetrahedron, kRoots> result;
  std::array<std::size_t, 3> axes{0, 1, 2};
  for (GridTetrahedron& t : result) {
    LatticePoint p{0, 0, 0};
    t.corners[0] = p;
    for (std::size_t i = 0; i < 3; ++i) {
      p[axes[i]] = BisectionGrid::kSize;
      t.corners[i + 1] = p;
    }
    std::next_permutation(axes.begin(), axes.end());
  }
  return result;
}

/// A point in steps from the origin.
using Place = std::array<double, 3>;

Place place_of(const LatticePoint& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

/// Returns a value that is positive on one side of the plane through three points, and negative on
/// the other. It is exact for lattice points: no product needs more than 53 bits.
double side(const Place& a, const Place& b, const Place& c, const Place& p) {
  const std::array<double, 3> u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const std::array<double, 3> v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  const std::array<double, 3> w{p[0] - a[0], p[1] - a[1], p[2] - a[2]};
  return w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) +
         w[2] * (u[0] * v[1] - u[1] * v[0]);
}

/// Tells in which half of a tetrahedron a point of it lies: positive in the first half, negative in
/// the second, 0 in both.
double half_of(const GridTetrahedron& t, const Place& p) {
  const std::size_t k = second_end(t);
  std::array<Place, 2> others;
  std::size_t n = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (i != k) others[n++] = place_of(t.corners[i]);
  }
  const Place z = place_of(middle(t));
  const double first = side(z, others[0], others[1], place_of(t.corners[0]));
  const double at = side(z, others[0], others[1], p);
  return first > 0.0 ? at : -at;
}

/// Tells whether a point of the cube lies in one of the six tetrahedra of the cube.
bool is_in_root(const GridTetrahedron& t, const Place& p) {
  const Place a = place_of(t.corners[0]);
  const Place b = place_of(t.corners[1]);
  const Place c = place_of(t.corners[2]);
  const Place d = place_of(t.corners[3]);
  const auto same_side = [&p](const Place& u, const Place& v, const Place& w, const Place& apex) {
    return side(u, v, w, apex) * side(u, v, w, p) >= 0.0;
  };
  // Two faces of each of these tetrahedra lie in faces of the cube.
  return same_side(a, b, d, c) && same_side(a, c, d, b);
}

}  // namespace

BisectionGrid::BisectionGrid(const Box3& box) {
  const double longest = box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
  if (!(longest > 0.0) || !(longest <= 0x1p900) || !(longest >= 0x1p-900)) {
    throw InvalidArgument("the box of a grid is empty, a point, or not finite");
  }
  // The size is the power of two above 9/8 of the longest side plus the cell by which the origin is
  // rounded.
  step_ = std::ldexp(1.0, std::ilogb(longest * 1.2) + 1) / kSize;
  const double cell = kOriginSteps * step_;
  const Vec3 spare = (Vec3::Constant(kSize * step_) - box.sizes()) / 2.0;
  origin_ = ((box.min() - spare) / cell).array().round().matrix() * cell;
  const double farthest = std::max(origin_.cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  if (!(farthest / step_ < kMostSteps)) {
    throw InvalidArgument("the box of a grid is too small for its distance from the origin");
  }
  for (const GridTetrahedron& root : roots()) nodes_.push_back({root});
}

Vec3 BisectionGrid::place(const LatticePoint& point) const {
  return origin_ + step_ * Vec3(point[0], point[1], point[2]);
}

void BisectionGrid::bisect(Index number) {
  if (nodes_[number].halves != kNoIndex || tetrahedron(number).level >= kMaxLevel) return;
  for (const Index i : all_round_edge(number)) {
    nodes_[i].halves = static_cast<Index>(nodes_.size());
    for (const GridTetrahedron& half : halves_of(nodes_[i].tetrahedron)) nodes_.push_back({half});
  }
}

// All tetrahedra that share the bisected edge are bisected together and must be of the same level:
// so coarser ones are bisected before.
std::vector<Index> BisectionGrid::all_round_edge(Index number) {
  const GridTetrahedron t = tetrahedron(number);
  const Place a = place_of(t.corners[0]);
  const Place b = place_of(t.corners[second_end(t)]);
  std::vector<Index> holding;
  for (Index root = 0; root < kRoots; ++root) {
    if (is_in_root(tetrahedron(root), a) && is_in_root(tetrahedron(root), b)) {
      holding.push_back(root);
    }
  }
  std::vector<Index> next;
  for (std::uint32_t level = 0; level < t.level; ++level) {
    next.clear();
    for (const Index ancestor : holding) {
      bisect(ancestor);
      const double half_a = half_of(tetrahedron(ancestor), a);
      const double half_b = half_of(tetrahedron(ancestor), b);
      const Index first = nodes_[ancestor].halves;
      if (half_a >= 0.0 && half_b >= 0.0) next.push_back(first);
      if (half_a <= 0.0 && half_b <= 0.0) next.push_back(first + 1);
    }
    std::swap(holding, next);
  }
  return holding;
}

std::optional<std::array<Index, 2>> BisectionGrid::halves(Index number) const {
  const Index first = nodes_[number].halves;
  return first == kNoIndex ? std::nullopt : std::optional(std::array{first, first + 1});
}

Index BisectionGrid::leaf_at(const Vec3& place) const {
  const Vec3 steps = (place - origin_) / step_;
  const Place p{steps.x(), steps.y(), steps.z()};
  Index i = 0;
  while (i + 1 < kRoots && !is_in_root(tetrahedron(i), p)) ++i;
  while (nodes_[i].halves != kNoIndex) {
    i = nodes_[i].halves + (half_of(tetrahedron(i), p) >= 0.0 ? 0 : 1);
  }
  return i;
}

std::size_t BisectionGrid::n_leaves() const {
  // Each bisection adds two tetrahedra, and one more is not bisected.
  return (nodes_.size() + kRoots) / 2;
}

std::vector<Index> BisectionGrid::leaves() const {
  std::vector<Index> result;
  result.reserve(nodes_.size() / 2 + kRoots);
  std::vector<Index> open;
  for (Index root = kRoots; root-- > 0;) open.push_back(root);
  while (!open.empty()) {
    const Index i = open.back();
    open.pop_back();
    if (const auto parts = halves(i)) {
      open.insert(open.end(), {(*parts)[1], (*parts)[0]});
    } else {
      result.push_back(i);
    }
  }
  return result;
}

}  // namespace meshalyzer
