#pragma once

#include "meshalyzer/spatial/box_tree.h"
#include "meshalyzer/spatial/closest_point.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace meshalyzer {

/// Returns the largest distance from a point of one triangle to the nearest point of another.
///
/// The distance from a convex set, such as a triangle, is a convex function, so that its maximum
/// over a triangle is at a corner.
[[nodiscard]] double largest_distance(const Corners& from, const Corners& to);

/// The distance of the points of a triangle from a surface.
struct FaceDistance {
  /// An upper bound of the largest distance.
  double largest = 0.0;
  /// Tells whether a point is farther than the bound, or may be.
  bool is_far = false;
};

/// The question that is answered of each triangle.
enum class DistanceQuestion {
  /// Is it within the bound? The answer takes a small part of the time, and tells no more of the
  /// largest distance than that it is at most the bound.
  IsWithin,
  /// How far is it?
  HowFar,
};

/// Measures how far triangles are from a surface, one after the other.
///
/// The method is branch and bound, as for Hausdorff distances between meshes (Guthe, Borodin and
/// Klein 2005): a triangle is cut into pieces until the bounds of each are tight enough. No point
/// of a piece is farther from the surface than its farthest corner is from any one face, nor than
/// its middle is from the surface plus its own radius. If these bounds are too loose, the part of a
/// piece that is near enough to one face is cut off.
class SurfaceDistance {
 public:
  /// The resolution of all answers, as a fraction of the bound.
  static constexpr double kResolution = 1e-3;

  /// @param closest  Over `tree`; both must outlive this.
  /// @param known    The largest distance of other triangles, which is not to be told again: what
  ///                 is nearer than this need not be known.
  SurfaceDistance(const FaceTree& tree, const ClosestPoints& closest, double bound,
                  DistanceQuestion question, double known)
      : tree_(tree),
        closest_(closest),
        bound_(bound),
        slack_(kResolution * bound),
        question_(question),
        found_(known) {}

  /// Measures a triangle. For one within the bound, the answer exceeds by at most the resolution
  /// the largest distance of a point of it, or of a triangle that was measured before or is known.
  /// A triangle over so many faces that this would take too long is reported as within the bound if
  /// that is proved, else as far.
  ///
  /// @param doubtful  If it is given, the points of the triangle outside of its boxes are known to
  ///                  be within the bound. Only for DistanceQuestion::IsWithin.
  [[nodiscard]] FaceDistance measure(const Corners& corners, const BoxTree* doubtful = nullptr);

 private:
  struct Piece {
    Corners corners;
    /// The distances of the corners from the surface.
    std::array<double, 3> distances{};
    /// The number of cuts that led to the piece.
    std::uint32_t depth = 0;
  };
  /// A face of the surface that may be near to all of a piece, and the distances of its corners
  /// from it.
  struct Candidate {
    Index slot = kNoIndex;
    std::array<double, 3> distances{};
  };
  /// The bounds of the distance of a piece.
  struct Estimate {
    double lower = 0.0;
    double upper = 0.0;
    std::array<Candidate, 4> candidates;
    std::size_t n_candidates = 0;
  };
  /// A line across a piece, through the two edges at one corner, the apex. One side of it is near
  /// enough to a face.
  struct Clip {
    std::size_t apex = 0;
    /// The fractions of the edge to the next corner, and of the edge to the one after, where the
    /// line crosses them: 0 at the apex.
    std::array<double, 2> at{0.0, 0.0};
    /// Tells whether the apex is on that side.
    bool is_apex_done = false;
    /// The fraction of the area on that side.
    double share = 0.0;
  };
  /// A point of an edge of a piece, which runs from one corner to another.
  struct Cut {
    std::size_t from = 0;
    std::size_t to = 0;
    double at = 0.5;
  };

  /// Returns how far a triangle is from the face that was nearest last, if only the bound is asked
  /// for and this is within it. Neighbours are mostly near to one face; where the bound is larger
  /// than most faces, nearly all are, and the nearest of them is not worth searching.
  [[nodiscard]] std::optional<double> distance_from_latest(const Corners& corners) const;
  [[nodiscard]] SurfacePoint closest(const Vec3& point);
  [[nodiscard]] Corners corners_of(Index slot) const;
  [[nodiscard]] bool is_precise(const Estimate& known) const;
  [[nodiscard]] Estimate estimate(const Piece& piece);
  void add_candidate(const Piece& piece, Index slot, Estimate& known) const;
  [[nodiscard]] static Cut halve_longest_edge(const Corners& corners);
  [[nodiscard]] double exit_at(Index slot, const std::array<Vec3, 2>& segment, double level) const;
  [[nodiscard]] Clip clip_for(const Piece& piece, const Candidate& face, double level) const;
  void divide(const Piece& piece, const Estimate& known);
  void divide_segment(const Piece& piece, const Estimate& known, double level);
  void keep_remainder(const Piece& piece, const Clip& clip);
  void cut_in_two(const Piece& piece, const Cut& where);

  const FaceTree& tree_;
  const ClosestPoints& closest_;
  double bound_;
  double slack_;
  DistanceQuestion question_;
  /// Tells whether the rest of the current triangle need only be within the bound.
  bool asks_within_ = false;
  /// The largest distance of a point found until now, where the distance was asked for.
  double found_;
  /// An upper bound of the distance of the finished parts of the current triangle.
  double done_ = 0.0;
  /// The slot of the latest answer.
  Index hint_ = kNoIndex;
  std::vector<Piece> work_;
};

}  // namespace meshalyzer
