#pragma once

#include "meshalyzer/repair/weld/internal/weld_edges.h"
#include "meshalyzer/spatial/box_tree.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): the lengths over which borders are welded.

/// The steps in which lengths grow. Where they end does not depend on how far they go, so that
/// repairs within different lengths have them in common.
class WeldSteps {
 public:
  /// @param shortest  The end of the first step.
  /// @param n_faces   The size of the mesh. Work grows with it, and with the square of the number
  /// of steps: small meshes have four of them in each power of two, large ones one.
  WeldSteps(double shortest, std::size_t n_faces);

  /// Returns the end of the step that a distance belongs to.
  [[nodiscard]] double end_of(double distance) const;

 private:
  double shortest_;
  /// The ends of the last steps up to each power of two, as a fraction of it.
  std::span<const double> ends_;
};

/// The distances between border edges: those between their ends, and those of ends from edges. If
/// none of them lies between two lengths, welding within the one is welding within the other.
class WeldDistances {
 public:
  WeldDistances(std::span<const Vec3> positions, std::span<const WeldEdge> edges);

  /// Returns the numbers of all edges.
  [[nodiscard]] std::vector<Index> all_edges() const;

  /// Returns the end of the first step in which one of these edges may be joined with another;
  /// nothing if there is none up to the limit.
  [[nodiscard]] std::optional<double> first_step(std::span<const Index> of, const WeldSteps& steps,
                                                 double limit) const;

  /// Returns the end of the next step behind `length` that has a distance in it, or may have;
  /// nothing if no distance up to the limit is left. Steps in which no edges may be joined are left
  /// out.
  [[nodiscard]] std::optional<double> next_step(const WeldSteps& steps, double length,
                                                double limit) const;

  /// Returns the numbers of the edges for which it makes no difference whether borders are welded
  /// within `limit` or within the greater `length`: neither they nor any edge that they are
  /// connected with have a distance between the two. Edges are connected if they are within
  /// `length` of each other, or their faces share a vertex. Where edges are so dense that finding
  /// this would take long, there are none.
  ///
  /// @return The edges, ascending.
  [[nodiscard]] std::vector<Index> edges_without_distance(double limit, double length) const;

 private:
  enum class Visited : std::uint8_t { All, Some, TooMany };
  /// Lengths above `known`, up to `limit`.
  struct Range {
    double known = 0.0;
    double limit = 0.0;
  };
  using VisitPair = std::function<bool(Index, Index)>;
  /// A distance of two edges if it is below the third argument; else one no less than that.
  using PairDistance = std::function<double(Index, Index, double)>;

  [[nodiscard]] Visited visit_pairs(std::span<const Index> of, double within,
                                    const VisitPair& visit) const;
  [[nodiscard]] bool is_any_within(std::span<const Index> of, const PairDistance& distance,
                                   double length) const;
  [[nodiscard]] std::optional<double> step_of_least(std::span<const Index> of,
                                                    const PairDistance& distance,
                                                    const WeldSteps& steps, Range range) const;
  [[nodiscard]] double joining_distance(Index a, Index b, double below) const;
  [[nodiscard]] double from_edge(Index v, const WeldEdge& edge) const;
  [[nodiscard]] double least_above(Index a, Index b, double length) const;

  std::span<const Vec3> positions_;
  std::span<const WeldEdge> edges_;
  std::vector<Box3> boxes_;
  BoxTree tree_;
};

}  // namespace meshalyzer
