#include "meshalyzer/picture/internal/vertex_clusters.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/parallel_sort.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

/// The name of a cell: vertices in the same cell have the same key.
using CellKey = std::uint64_t;

/// The number of bits of a coordinate in a key.
constexpr int kAxisBits = 21;
constexpr CellKey kPinned = CellKey{1} << (3 * kAxisBits);
constexpr double kMaxCells = static_cast<double>((CellKey{1} << kAxisBits) - 1);

/// The largest number of cell sizes that are tried. The search ends earlier if at least this share
/// of the allowed faces is left.
constexpr int kMaxTries = 12;
constexpr double kEnough = 0.8;

/// A grid of cubes, a given number of them along the longest side of a box.
class Grid {
 public:
  Grid(const Box3& box, double per_side)
      : origin_(box.min()), last_(std::min(std::ceil(per_side) - 1, kMaxCells)) {
    const double longest = box.sizes().maxCoeff();
    per_length_ = longest > 0.0 ? per_side / longest : 0.0;
  }

  [[nodiscard]] CellKey cell_at(const Vec3& place) const {
    CellKey key = 0;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double steps = std::min((place[i] - origin_[i]) * per_length_, last_);
      key = key << kAxisBits | static_cast<CellKey>(steps);
    }
    return key;
  }

 private:
  Vec3 origin_;
  /// The last cell, which also contains points on the far side of the box.
  double last_;
  double per_length_;
};

/// The cells of vertices, numbered in the order of their keys.
struct Cells {
  std::size_t count = 0;
  /// #V: the cell of each vertex; kNoIndex where it is not used.
  std::vector<Index> of_vertex;
};

/// The vertices that the faces use, in drawn coordinates, and the cells they fall into.
class Clustering {
 public:
  Clustering(const Soup& soup, const DrawingFrame& frame, std::span<const Index> faces)
      : soup_(soup), faces_(faces), places_(soup.n_vertices(), Vec3::Zero()) {
    is_used_.assign(soup.n_vertices(), 0);
    for (const Index f : faces) {
      for (const Index v : soup.triangles[f]) is_used_[v] = 1;
    }
    for (Index v = 0; v < places_.size(); ++v) {
      if (is_used_[v] == 0) continue;
      places_[v] = frame(soup.positions[v]);
      box_.extend(places_[v]);
    }
  }

  /// Assigns each vertex to a cell, with a given number of cells along the longest side of the box.
  ///
  /// @param pinned  Marks vertices that have a cell of their own; empty if none has.
  [[nodiscard]] std::vector<CellKey> cells(double per_side,
                                           std::span<const std::uint8_t> pinned) const {
    std::vector<CellKey> keys(places_.size(), 0);
    const Grid grid(box_, per_side);
    parallel_chunks(places_.size(), [&](Chunk chunk) {
      for (std::size_t v = chunk.begin; v < chunk.end; ++v) {
        const bool is_pinned = !pinned.empty() && pinned[v] != 0;
        if (is_used_[v] != 0) keys[v] = is_pinned ? kPinned | v : grid.cell_at(places_[v]);
      }
    });
    return keys;
  }

  /// Counts the faces whose corners are in three different cells.
  [[nodiscard]] std::size_t n_kept(const std::vector<CellKey>& keys) const {
    const auto counts = map_chunks<std::size_t>(faces_.size(), [&](Chunk chunk) {
      std::size_t n = 0;
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        const Triangle& t = soup_.triangles[faces_[i]];
        n += are_different(keys[t[0]], keys[t[1]], keys[t[2]]) ? 1 : 0;
      }
      return n;
    });
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  }

  [[nodiscard]] TriangleList merge(const std::vector<CellKey>& keys) const;

 private:
  static bool are_different(CellKey a, CellKey b, CellKey c) { return a != b && b != c && c != a; }

  [[nodiscard]] Cells number_cells(const std::vector<CellKey>& keys) const;
  /// Chooses the vertex that represents each cell.
  [[nodiscard]] std::vector<Index> representatives(const Cells& cells) const;

  const Soup& soup_;
  std::span<const Index> faces_;
  std::vector<Vec3> places_;
  std::vector<std::uint8_t> is_used_;
  Box3 box_;
};

/// A face after clustering: its corners ascending, so that equal faces are found, and its position
/// in the list.
struct MergedFace {
  Triangle sorted;
  Index place;
};

/// Keeps the first of equal faces, in the order of the list.
void drop_duplicates(std::vector<MergedFace>& merged) {
  std::sort(merged.begin(), merged.end(), [](const MergedFace& a, const MergedFace& b) {
    return std::tie(a.sorted, a.place) < std::tie(b.sorted, b.place);
  });
  const auto last =
      std::unique(merged.begin(), merged.end(),
                  [](const MergedFace& a, const MergedFace& b) { return a.sorted == b.sorted; });
  merged.erase(last, merged.end());
  std::sort(merged.begin(), merged.end(),
            [](const MergedFace& a, const MergedFace& b) { return a.place < b.place; });
}

Cells Clustering::number_cells(const std::vector<CellKey>& keys) const {
  std::vector<CellKey> names;
  for (std::size_t v = 0; v < keys.size(); ++v) {
    if (is_used_[v] != 0) names.push_back(keys[v]);
  }
  parallel_sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  Cells cells{names.size(), std::vector<Index>(keys.size(), kNoIndex)};
  parallel_chunks(keys.size(), [&](Chunk chunk) {
    for (std::size_t v = chunk.begin; v < chunk.end; ++v) {
      if (is_used_[v] == 0) continue;
      const auto name = std::lower_bound(names.begin(), names.end(), keys[v]);
      cells.of_vertex[v] = static_cast<Index>(name - names.begin());
    }
  });
  return cells;
}

std::vector<Index> Clustering::representatives(const Cells& cells) const {
  const std::vector<Index>& cell_of = cells.of_vertex;
  std::vector<Vec3> mean(cells.count, Vec3::Zero());
  std::vector<double> n_vertices(cells.count, 0.0);
  for (std::size_t v = 0; v < cell_of.size(); ++v) {
    if (cell_of[v] == kNoIndex) continue;
    mean[cell_of[v]] += places_[v];
    n_vertices[cell_of[v]] += 1.0;
  }
  for (std::size_t c = 0; c < cells.count; ++c) mean[c] /= n_vertices[c];
  std::vector<double> nearest(cells.count, std::numeric_limits<double>::infinity());
  std::vector<Index> vertex(cells.count, kNoIndex);
  for (Index v = 0; v < cell_of.size(); ++v) {
    const Index c = cell_of[v];
    if (c == kNoIndex) continue;
    const double distance = (places_[v] - mean[c]).squaredNorm();
    if (vertex[c] != kNoIndex && distance >= nearest[c]) continue;
    nearest[c] = distance;
    vertex[c] = v;
  }
  return vertex;
}

TriangleList Clustering::merge(const std::vector<CellKey>& keys) const {
  const Cells numbered = number_cells(keys);
  const std::vector<Index>& cell_of = numbered.of_vertex;
  const std::vector<Index> vertex = representatives(numbered);
  std::vector<MergedFace> merged;
  for (Index i = 0; i < faces_.size(); ++i) {
    const Triangle& t = soup_.triangles[faces_[i]];
    Triangle cells{cell_of[t[0]], cell_of[t[1]], cell_of[t[2]]};
    if (!are_different(cells[0], cells[1], cells[2])) continue;
    std::sort(cells.begin(), cells.end());
    merged.push_back({cells, i});
  }
  drop_duplicates(merged);
  TriangleList list;
  for (const MergedFace& face : merged) {
    const Index f = faces_[face.place];
    Triangle t = soup_.triangles[f];
    for (Index& v : t) v = vertex[cell_of[v]];
    list.triangles.push_back(t);
    list.faces.push_back(f);
  }
  return list;
}

/// Searches a number of cells that leaves as many faces as allowed.
class CellSearch {
 public:
  CellSearch(const Clustering& clustering, const ClusterLimits& limits)
      : clustering_(clustering), limits_(limits) {}

  /// Finds the cells of the finest grid that leaves few enough faces.
  ///
  /// @return Empty if even the coarsest grid, one cell, leaves too many faces at pinned vertices.
  [[nodiscard]] std::vector<CellKey> run() {
    if (!try_cells(1.0)) return {};
    double next = 256.0;
    for (int i = 0; i < kMaxTries && !is_enough(); ++i) {
      const bool fits = try_cells(next);
      (fits ? low_ : high_) = next;
      next = next_try(next);
      if (high_ / low_ < 1.01) break;
    }
    return std::move(best_);
  }

 private:
  bool try_cells(double per_side) {
    std::vector<CellKey> keys = clustering_.cells(per_side, limits_.pinned);
    n_last_ = clustering_.n_kept(keys);
    if (n_last_ > limits_.max_faces) return false;
    n_best_ = n_last_;
    best_ = std::move(keys);
    return true;
  }

  [[nodiscard]] bool is_enough() const {
    return static_cast<double>(n_best_) >= kEnough * static_cast<double>(limits_.max_faces);
  }

  /// Returns the number of cells per side to try next. The number of remaining faces grows with its
  /// square on a surface; if the estimate is out of bounds, their mean is tried.
  [[nodiscard]] double next_try(double last) const {
    const double wanted = (1.0 + kEnough) / 2 * static_cast<double>(limits_.max_faces);
    const double left = std::max(static_cast<double>(n_last_), 1.0);
    const double guess = last * std::clamp(std::sqrt(wanted / left), 1.0 / 64, 64.0);
    return guess > low_ && guess < high_ ? guess : std::sqrt(low_ * high_);
  }

  const Clustering& clustering_;
  ClusterLimits limits_;
  /// The bounds of the search: cells per side that leave few enough faces, and too many.
  double low_ = 1.0;
  double high_ = kMaxCells;
  std::size_t n_last_ = 0;
  std::size_t n_best_ = 0;
  std::vector<CellKey> best_;
};

}  // namespace

TriangleList cluster_vertices(const Soup& soup, const DrawingFrame& frame, std::vector<Index> faces,
                              const ClusterLimits& limits) {
  if (faces.size() <= limits.max_faces) return triangles_of(soup, std::move(faces));
  const Clustering clustering(soup, frame, faces);
  std::vector<CellKey> keys = CellSearch(clustering, limits).run();
  if (keys.empty()) keys = CellSearch(clustering, {limits.max_faces, {}}).run();
  return clustering.merge(keys);
}

}  // namespace meshalyzer
