#include "meshalyzer/geometry/fitted_normals.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/one_ring.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace meshalyzer {
namespace {

constexpr std::size_t kMostNeighbours = 16;
/// If the previous columns leave less than this share of a column of the fit unexplained, the rest
/// is rounding error.
constexpr double kWellPosed = 1e-9;
/// A slope with at least this standard error is no better than the given normal.
constexpr double kUnsure = 0.2;

/// The number of unknowns. They are eliminated in order; the last two give the normal.
constexpr std::size_t kUnknowns = 5;
constexpr std::size_t kSlopeX = 3;
constexpr std::size_t kSlopeY = 4;

constexpr int kNoVertex = -1;

/// The neighbours of a vertex, filled up with kNoVertex; empty if they are too many. The array has
/// the length of a cache line.
using Ring = std::array<int, kMostNeighbours>;

Ring ring_of(const TriMesh& mesh, VertexHandle v) {
  Ring ring;
  ring.fill(kNoVertex);
  std::size_t n = 0;
  for (const VertexHandle w : one_ring_vertices(mesh, v)) {
    if (n == kMostNeighbours) {
      ring.fill(kNoVertex);
      break;
    }
    ring[n++] = w.idx();
  }
  return ring;
}

/// The vertices within two edges of a vertex, each once.
class TwoRing {
 public:
  TwoRing(const std::vector<Ring>& rings, int centre) {
    slots_.fill(kNoVertex);
    add(centre);
    for (const int v : rings[static_cast<std::size_t>(centre)]) {
      if (v == kNoVertex) break;
      add(v);
      for (const int w : rings[static_cast<std::size_t>(v)]) {
        if (w == kNoVertex) break;
        add(w);
      }
    }
  }

  /// Returns the first member after the centre.
  [[nodiscard]] const int* begin() const { return members_.data() + 1; }
  [[nodiscard]] const int* end() const { return members_.data() + n_; }

 private:
  /// Adds a vertex unless it is a member already. It does not branch on whether the vertex is new,
  /// since half of them are.
  void add(int v) {
    std::size_t slot = static_cast<std::size_t>(v) % kSlots;
    while (slots_[slot] != kNoVertex && slots_[slot] != v) slot = (slot + 1) % kSlots;
    members_[n_] = v;
    n_ += slots_[slot] == kNoVertex ? 1 : 0;
    slots_[slot] = v;
  }

  static constexpr std::size_t kMost = 1 + kMostNeighbours * kMostNeighbours;
  /// The number of slots exceeds the number of members, so that a free one is always found.
  static constexpr std::size_t kSlots = 512;
  static_assert(kMost < kSlots);

  /// One more than the number of members, because add() writes before it tests.
  std::array<int, kMost + 1> members_;
  std::size_t n_ = 0;
  std::array<int, kSlots> slots_;
};

/// The normal equations of a weighted least-squares fit.
class Fit {
 public:
  void add(const std::array<double, kUnknowns>& row, double value, double weight) {
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      const double weighted = weight * row[i];
      for (std::size_t j = 0; j <= i; ++j) matrix_[i][j] += weighted * row[j];
      right_[i] += weighted * value;
    }
    residual_ += weight * value * value;
    ++n_;
  }

  /// Brings the matrix to triangular form, by Cholesky.
  ///
  /// @return  True if the fit is well posed; only then is there a solution.
  [[nodiscard]] bool eliminate() {
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      const double whole = matrix_[i][i];
      for (std::size_t j = 0; j <= i; ++j) {
        for (std::size_t k = 0; k < j; ++k) matrix_[i][j] -= matrix_[i][k] * matrix_[j][k];
        if (j < i) matrix_[i][j] /= matrix_[j][j];
      }
      if (!(matrix_[i][i] > kWellPosed * whole)) return false;
      matrix_[i][i] = std::sqrt(matrix_[i][i]);
      for (std::size_t k = 0; k < i; ++k) right_[i] -= matrix_[i][k] * right_[k];
      right_[i] /= matrix_[i][i];
      residual_ -= right_[i] * right_[i];
    }
    return true;
  }

  /// Tells whether there are more points than unknowns, and these lie so close to the quadric that
  /// its slopes are certain.
  [[nodiscard]] bool is_sure() const {
    if (n_ <= kUnknowns) return false;
    const double y = 1.0 / matrix_[kSlopeY][kSlopeY];
    const double x = std::hypot(1.0, matrix_[kSlopeY][kSlopeX] * y) / matrix_[kSlopeX][kSlopeX];
    const double variance = residual_ / static_cast<double>(n_ - kUnknowns);
    return variance * (x * x + y * y) < kUnsure * kUnsure;
  }

  /// Returns the slopes along x and y.
  [[nodiscard]] Eigen::Vector2d slopes() const {
    const double y = right_[kSlopeY] / matrix_[kSlopeY][kSlopeY];
    return {(right_[kSlopeX] - matrix_[kSlopeY][kSlopeX] * y) / matrix_[kSlopeX][kSlopeX], y};
  }

 private:
  /// The lower half of the matrix.
  std::array<std::array<double, kUnknowns>, kUnknowns> matrix_{};
  std::array<double, kUnknowns> right_{};
  /// The weighted sum of squares: at first of the values, at the end of the residuals.
  double residual_ = 0.0;
  std::size_t n_ = 0;
};

/// The vertices to which surfaces are fitted, with their normals and neighbours.
struct Vertices {
  const TriMesh& mesh;
  const std::vector<Vec3>& normals;
  const std::vector<Ring>& rings;

  [[nodiscard]] const Vec3& point(int v) const { return mesh.point(VertexHandle(v)); }
  [[nodiscard]] const Vec3& normal(int v) const { return normals[static_cast<std::size_t>(v)]; }
};

Vec3 fitted_normal(const Vertices& vertices, int v) {
  const Vec3& normal = vertices.normal(v);
  const Vec3 x_axis = normal.unitOrthogonal();
  const Vec3 y_axis = normal.cross(x_axis);
  const Vec3& centre = vertices.point(v);
  Fit fit;
  for (const int w : TwoRing(vertices.rings, v)) {
    const Vec3 p = vertices.point(w) - centre;
    const double square = p.squaredNorm();
    // Points where the surface has turned away, behind a sharp edge or a thin wall, are skipped:
    // there it is no graph. A vertex without a normal uses no points at all.
    if (!(vertices.normal(w).dot(normal) > 0.0) || square == 0.0) continue;
    const double x = p.dot(x_axis);
    const double y = p.dot(y_axis);
    fit.add({x * x - y * y, x * y, square, x, y}, p.dot(normal), 1.0 / square);
  }
  if (!fit.eliminate() || !fit.is_sure()) return normal;
  const Eigen::Vector2d slope = fit.slopes();
  return (normal - slope.x() * x_axis - slope.y() * y_axis).normalized();
}

}  // namespace

std::vector<Vec3> fitted_normals(const TriMesh& mesh, const std::vector<Vec3>& normals) {
  std::vector<Ring> rings(normals.size());
  parallel_chunks(rings.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      rings[i] = ring_of(mesh, VertexHandle(static_cast<int>(i)));
    }
  });
  std::vector<Vec3> fitted(normals.size());
  parallel_chunks(normals.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      fitted[i] = fitted_normal({mesh, normals, rings}, static_cast<int>(i));
    }
  });
  return fitted;
}

}  // namespace meshalyzer
