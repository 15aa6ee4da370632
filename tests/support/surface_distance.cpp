#include "support/surface_distance.h"

#include "meshalyzer/base/parallel.h"
#include "support/constants.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace meshalyzer::test {
namespace {

/// Cells along the longest side of the grid, at most.
constexpr double kMaxCells = 64;

using Points = std::array<Vec3, 3>;
using Cell = std::array<long, 3>;
using Counts = std::function<bool(const Vec3& point, const Vec3& normal)>;

/// The faces that are in the complex.
std::vector<Points> faces_of(const Soup& soup) {
  std::vector<Points> faces;
  for (const Triangle& t : soup.triangles) {
    if (is_in_complex(t)) {
      faces.push_back({soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]});
    }
  }
  return faces;
}

double distance_from_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double squared = along.squaredNorm();
  const double at = squared > 0.0 ? std::clamp(along.dot(p - a) / squared, 0.0, 1.0) : 0.0;
  return (p - (a + at * along)).norm();
}

/// Least of the distances from the edges and, where the point stands above the inside, the plane.
double distance_from_face(const Vec3& p, const Points& face) {
  const auto& [a, b, c] = face;
  double least = std::min({distance_from_segment(p, a, b), distance_from_segment(p, b, c),
                           distance_from_segment(p, c, a)});
  const Vec3 normal = (b - a).cross(c - a);
  const bool is_above = normal.dot((b - a).cross(p - a)) > 0.0 &&
                        normal.dot((c - b).cross(p - b)) > 0.0 &&
                        normal.dot((a - c).cross(p - c)) > 0.0;
  if (is_above) {
    least = std::min(least, std::abs(normal.dot(p - a)) / normal.norm());
  }
  return least;
}

/// Faces sorted into cubes of space: each is in all cubes that its box meets.
class Grid {
 public:
  /// @param faces  At least one.
  explicit Grid(std::vector<Points> faces) : faces_(std::move(faces)) {
    for (const Points& face : faces_) {
      for (const Vec3& p : face) box_.extend(p);
    }
    const double longest = box_.sizes().maxCoeff();
    const double n = std::clamp(std::sqrt(static_cast<double>(faces_.size())), 1.0, kMaxCells);
    side_ = longest > 0.0 ? longest / std::floor(n) : 1.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double size = box_.sizes()[static_cast<Eigen::Index>(k)];
      n_cells_[k] = 1 + static_cast<long>(size / side_);
    }
    cells_.resize(static_cast<std::size_t>(n_cells_[0] * n_cells_[1] * n_cells_[2]));
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      insert(i);
    }
  }

  /// Looks into shells of cubes round the one that is nearest to the point. A cube of shell r is no
  /// nearer than r - 1 sides.
  [[nodiscard]] double distance(const Vec3& p) const {
    const Cell middle = cell_at(p);
    const long n_shells = std::max({n_cells_[0], n_cells_[1], n_cells_[2]});
    double least = kInfinity;
    for (long r = 0; r < n_shells && static_cast<double>(r - 1) * side_ <= least; ++r) {
      for_shell(middle, r, [&](const Cell& cell) {
        for (const std::size_t face : cells_[number(cell)]) {
          least = std::min(least, distance_from_face(p, faces_[face]));
        }
      });
    }
    return least;
  }

 private:
  [[nodiscard]] Cell cell_at(const Vec3& p) const {
    Cell cell;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const double at = std::floor((p[axis] - box_.min()[axis]) / side_);
      cell[k] = static_cast<long>(std::clamp(at, 0.0, static_cast<double>(n_cells_[k] - 1)));
    }
    return cell;
  }

  [[nodiscard]] std::size_t number(const Cell& c) const {
    return static_cast<std::size_t>((c[0] * n_cells_[1] + c[1]) * n_cells_[2] + c[2]);
  }

  /// Visits the cubes that are r from the middle one along some axis, and not more along any.
  template <typename Visit>
  void for_shell(const Cell& middle, long r, Visit&& visit) const {
    const auto is_end = [&](std::size_t k, long i) { return std::labs(i - middle[k]) == r; };
    const auto low = [&](std::size_t k) { return std::max(0L, middle[k] - r); };
    const auto high = [&](std::size_t k) { return std::min(n_cells_[k] - 1, middle[k] + r); };
    for (long x = low(0); x <= high(0); ++x) {
      for (long y = low(1); y <= high(1); ++y) {
        const long step = is_end(0, x) || is_end(1, y) ? 1 : std::max(1L, 2 * r);
        for (long z = middle[2] - r; z <= middle[2] + r; z += step) {
          if (z >= 0 && z < n_cells_[2]) visit(Cell{x, y, z});
        }
      }
    }
  }

  void insert(std::size_t face) {
    Box3 box;
    for (const Vec3& p : faces_[face]) box.extend(p);
    const Cell low = cell_at(box.min());
    const Cell high = cell_at(box.max());
    for (long x = low[0]; x <= high[0]; ++x) {
      for (long y = low[1]; y <= high[1]; ++y) {
        for (long z = low[2]; z <= high[2]; ++z) {
          cells_[number({x, y, z})].push_back(face);
        }
      }
    }
  }

  std::vector<Points> faces_;
  Box3 box_;
  double side_ = 1.0;
  Cell n_cells_{};
  std::vector<std::vector<std::size_t>> cells_;
};

double steps(double length, double spacing) {
  return std::max(1.0, std::ceil(length / spacing));
}

/// The largest distance of a sample. They stand in rows from the corner opposite to its shortest
/// edge, so that slivers have few.
double largest_of_samples(Points face, const Grid& grid, double spacing, const Counts& counts) {
  const auto edge = [&](std::size_t i) { return (face[(i + 2) % 3] - face[(i + 1) % 3]).norm(); };
  std::size_t top = edge(1) < edge(0) ? 1 : 0;
  top = edge(2) < edge(top) ? 2 : top;
  std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(top), face.end());
  const double n_rows = steps(std::max(edge(1), edge(2)), spacing);
  const Vec3 normal = (face[1] - face[0]).cross(face[2] - face[0]);
  double largest = 0.0;
  for (double row = 0.0; row <= n_rows; ++row) {
    const Vec3 left = face[0] + row / n_rows * (face[1] - face[0]);
    const Vec3 right = face[0] + row / n_rows * (face[2] - face[0]);
    const double n = steps((right - left).norm(), spacing);
    for (double i = 0.0; i <= n; ++i) {
      const Vec3 point = left + i / n * (right - left);
      const double distance = grid.distance(point);
      if (distance > largest && (!counts || counts(point, normal))) largest = distance;
    }
  }
  return largest;
}

}  // namespace

double sampled_distance(const Soup& from, const Soup& to, double spacing, const Counts& counts) {
  const std::vector<Points> faces = faces_of(from);
  std::vector<Points> others = faces_of(to);
  if (faces.empty() || others.empty()) {
    return faces.empty() ? 0.0 : kInfinity;
  }
  const Grid grid(std::move(others));
  double largest = 0.0;
  const auto parts = map_chunks<double>(faces.size(), [&](Chunk chunk) {
    double part = 0.0;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      part = std::max(part, largest_of_samples(faces[i], grid, spacing, counts));
    }
    return part;
  });
  for (const double part : parts) largest = std::max(largest, part);
  return largest;
}

double summed_winding(const Soup& soup, const Vec3& point) {
  double sum = 0.0;
  for (const auto& [a, b, c] : faces_of(soup)) {
    const Vec3 p = a - point;
    const Vec3 q = b - point;
    const Vec3 r = c - point;
    const double numerator = p.dot(q.cross(r));
    const double denominator = p.norm() * q.norm() * r.norm() + p.dot(q) * r.norm() +
                               q.dot(r) * p.norm() + r.dot(p) * q.norm();
    sum += 2.0 * std::atan2(numerator, denominator);
  }
  return sum / (4.0 * kPi);
}

}  // namespace meshalyzer::test
