#pragma once

#include "meshalyzer/repair/weld/internal/weld_edges.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): searches for border edges that are near each other.

/// Finds the points within reach of others.
class NearPoints {
 public:
  /// @param points  Indices into `positions`, each once.
  /// @param reach   A length above 0. If points are so dense that too many would be within it of
  /// each other, it is halved until they are few.
  /// @complexity    O(n log n).
  NearPoints(std::span<const Vec3> positions, std::span<const Index> points, double reach);

  /// Returns the reach in use.
  [[nodiscard]] double reach() const { return reach_; }

  /// Calls `visit` for the points within reach of one of `positions`, itself included if it is
  /// among them, in no particular order, until it returns false.
  template <typename Visit>
  void visit_near(Index vertex, Visit&& visit) const {
    const Vec3& p = positions_[vertex];
    visit_near_cells(p, [&](std::span<const Index> members) {
      for (const Index v : members) {
        const Vec3 offset = positions_[v] - p;
        // A cheap test comes first, with a margin for rounding: most points of a crowd are far.
        if (offset.cwiseAbs().maxCoeff() > 1.001 * reach_) continue;
        if (offset.stableNorm() <= reach_ && !visit(v)) return false;
      }
      return true;
    });
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  [[nodiscard]] std::int64_t cell_of(double coordinate) const;
  [[nodiscard]] Cell cell_of(const Vec3& p) const;
  [[nodiscard]] std::size_t first_slot(const Cell& cell) const;
  void sort_into_cells(std::span<const Index> points);
  [[nodiscard]] bool is_crowded() const;
  [[nodiscard]] std::span<const Index> members_of(const Cell& cell) const;

  template <typename Visit>
  void visit_near_cells(const Vec3& p, Visit&& visit) const {
    Cell low;
    Cell high;
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = p[static_cast<Eigen::Index>(i)];
      // A margin for rounding.
      low[i] = cell_of(x - 1.001 * reach_);
      high[i] = cell_of(x + 1.001 * reach_);
    }
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          if (!visit(members_of({x, y, z}))) return;
        }
      }
    }
  }

  std::span<const Vec3> positions_;
  double reach_;
  double width_ = 0.0;
  /// Points by cell, and where each non-empty cell begins.
  std::vector<Index> points_;
  std::vector<Cell> cells_;
  std::vector<Index> begin_;
  /// A hash table with open addressing: indices into cells_.
  std::vector<Index> slots_;
};

/// The input of find_weld_chains(). This holds references only.
struct NearEdges {
  std::span<const Vec3> positions;
  std::span<const WeldEdge> edges;
  /// #V: the places as find_weld_places() returns them.
  std::span<const Index> places;
  /// The edges at each place.
  const ItemsByGroup& at_places;
  /// The index that finds the places near a point.
  const NearPoints& near;
};

/// Pairs of edges that are near each other.
struct WeldCandidates {
  /// The pairs in ascending order, the lower edge first, each once.
  std::vector<WeldJoin> joins;
  /// The length within which ends must be.
  double reach = 0.0;
};

/// Finds the pairs of edges of different faces with both ends of one within reach of the ends of
/// the other. If an edge could be joined with another in both directions, only the better one is
/// listed, in doubt the one in which they run against each other.
///
/// @param wanted  The edges to search for, ascending.
/// @param reach   A length above 0. If edges are so short that too many would be within it of each
/// other, it is halved until they are few.
/// @complexity    O(#wanted + found).
[[nodiscard]] WeldCandidates find_weld_candidates(std::span<const Vec3> positions,
                                                  std::span<const WeldEdge> edges,
                                                  std::span<const Index> wanted, double reach);

}  // namespace meshalyzer
