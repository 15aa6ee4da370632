#pragma once

#include "meshalyzer/repair/driver/internal/convex_piece.h"
#include "meshalyzer/repair/driver/internal/near_region.h"
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
/// Klein 2005): a triangle is cut into convex pieces until the bounds of each are tight enough. No
/// point of a piece is farther from the surface than its farthest corner is from any one face. If
/// this bound is too loose, all of the piece that is near enough to one face is cut off at once.
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
  [[nodiscard]] FaceDistance measure(const Corners& corners);

  /// Tells whether a triangle is within the bound of which only a part is in doubt. Only for
  /// DistanceQuestion::IsWithin.
  ///
  /// @param part      What is to be measured of the triangle. The surface may lack what is farther
  ///                  than the bound from the box of this part.
  /// @param doubtful  Points outside of these boxes are known to be within the bound.
  [[nodiscard]] FaceDistance measure(const Corners& corners, const ConvexPiece& part,
                                     const BoxTree& doubtful);

 private:
  /// A piece that remains to be measured.
  struct Piece {
    ConvexPiece shape;
    /// The number of cuts that led to it.
    std::uint32_t depth = 0;
  };
  /// A place on a piece, and the nearest face.
  struct Nearest {
    Vec3 place;
    SurfacePoint found;
  };
  /// The bounds of the distance of a piece, and faces that may be near to much of it.
  struct Estimate {
    double lower = 0.0;
    double upper = 0.0;
    std::array<Nearest, 2> nearest;
    std::size_t n_nearest = 0;
  };

  void start_with(const Corners& triangle, const ConvexPiece& part);
  [[nodiscard]] FaceDistance measure_pieces(const BoxTree* doubtful);
  /// Returns how far a triangle is from the face that was nearest last, if only the bound is asked
  /// for and this is within it. Neighbours are mostly near to one face; where the bound is larger
  /// than most faces, nearly all are, and the nearest of them is not worth searching.
  [[nodiscard]] std::optional<double> distance_from_latest(const Corners& corners) const;
  [[nodiscard]] SurfacePoint closest(const Vec3& point);
  [[nodiscard]] Corners corners_of(Index slot) const;
  [[nodiscard]] bool is_precise(const Estimate& known) const;
  [[nodiscard]] Estimate estimate(const ConvexPiece& piece);
  void divide(const Piece& piece, const Estimate& known);
  [[nodiscard]] double cut_off_near(const ConvexPiece& piece, const Nearest& nearest, double level);
  [[nodiscard]] double size_of(const ConvexPiece& piece) const;
  void halve(const Piece& piece);
  void keep(const ConvexPiece& part, std::uint32_t depth);

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
  /// The plane of the current triangle; if it is a segment, except for rounding, any plane through
  /// it.
  FacePlane plane_;
  bool is_segment_ = false;
  double longest_side_ = 0.0;
  /// Its pieces.
  std::vector<Piece> work_;
  /// What remained when a part of a piece was cut off.
  std::vector<ConvexPiece> rest_;
};

}  // namespace meshalyzer
