#pragma once

#include "meshalyzer/spatial/closest_point.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// Returns the largest distance from a point of one triangle to the nearest point of another.
///
/// The distance from a triangle, or any convex set, is a convex function: of all points of a
/// triangle a corner is farthest.
[[nodiscard]] double largest_distance(const Corners& from, const Corners& to);

/// Tells how far the points of a triangle are from a surface.
struct FaceDistance {
  /// An upper bound of the distance of its farthest point.
  double largest = 0.0;
  /// Tells whether a point is farther than the bound, or may be.
  bool is_far = false;
};

/// The question that is answered of each triangle.
enum class DistanceQuestion {
  /// Is it within the bound? That takes a small part of the time; of the largest distance no more
  /// is known then than that it is at most the bound.
  IsWithin,
  /// How far is it?
  HowFar,
};

/// Measures how far triangles are from a surface, one after the other.
///
/// Branch and bound, as for Hausdorff distances between meshes (Guthe, Borodin and Klein 2005): a
/// triangle is cut into pieces until what is known of each is enough. A piece is nowhere farther
/// than its farthest corner is from any one face of the surface, nor than its middle is from the
/// surface plus its own radius. From a piece that this says too little of, the part is cut off that
/// is near enough to one face.
class SurfaceDistance {
 public:
  /// What is within the bound is told apart from what is not, and measured, to this part of the
  /// bound.
  static constexpr double kResolution = 1e-3;

  /// @param closest  Over `tree`; both must outlive this.
  SurfaceDistance(const FaceTree& tree, const ClosestPoints& closest, double bound,
                  DistanceQuestion question)
      : tree_(tree),
        closest_(closest),
        bound_(bound),
        slack_(kResolution * bound),
        question_(question) {}

  /// Returns the answer for a triangle that is within the bound is not more than the resolution
  /// above the largest distance of a point of it, or of a triangle that was measured before; but
  /// for one that lies over so many faces that this would take too long: that is told to be within
  /// the bound where that much is known, and else to be far.
  [[nodiscard]] FaceDistance measure(const Corners& corners);

 private:
  struct Piece {
    Corners corners;
    /// The distances of the corners from the surface.
    std::array<double, 3> distances{};
    /// Tells how often it was cut.
    std::uint32_t depth = 0;
  };
  /// A face of the surface that may be near to all of a piece, and how far its corners are from it.
  struct Candidate {
    Index slot = kNoIndex;
    std::array<double, 3> distances{};
  };
  /// What is known of a piece.
  struct Estimate {
    double lower = 0.0;
    double upper = 0.0;
    std::array<Candidate, 4> candidates;
    std::size_t n_candidates = 0;
  };
  /// A line across a piece, through the two edges at one corner, the apex: what is on one side of
  /// it is near enough to a face.
  struct Clip {
    std::size_t apex = 0;
    /// Where it crosses the edge to the next corner, and to the one after: 0 at the apex.
    std::array<double, 2> at{0.0, 0.0};
    /// Tells whether the apex is on that side.
    bool is_apex_done = false;
    /// The share of the area that is on that side.
    double share = 0.0;
  };
  /// A point of an edge of a piece, from one corner to another.
  struct Cut {
    std::size_t from = 0;
    std::size_t to = 0;
    double at = 0.5;
  };

  [[nodiscard]] SurfacePoint closest(const Vec3& point);
  [[nodiscard]] Corners corners_of(Index slot) const;
  [[nodiscard]] bool is_precise(const Estimate& known) const;
  [[nodiscard]] Estimate estimate(const Piece& piece);
  void add_candidate(const Piece& piece, Index slot, Estimate& known) const;
  [[nodiscard]] static Cut halve_longest_edge(const Corners& corners);
  [[nodiscard]] Clip clip_for(const Piece& piece, const Candidate& face, double level) const;
  void divide(const Piece& piece, const Estimate& known);
  void keep_remainder(const Piece& piece, const Clip& clip);
  void cut_in_two(const Piece& piece, const Cut& where);

  const FaceTree& tree_;
  const ClosestPoints& closest_;
  double bound_;
  double slack_;
  DistanceQuestion question_;
  /// The largest distance that a point was found to have.
  double found_ = 0.0;
  /// An upper bound of the distance of the parts of the current triangle that are done with.
  double done_ = 0.0;
  /// The slot of the latest answer.
  Index hint_ = kNoIndex;
  std::vector<Piece> work_;
};

}  // namespace meshalyzer
