#pragma once

#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/boolean/inside_rule.h"
#include "meshalyzer/boolean/operands.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace meshalyzer {

/// The default limit on the pairs that are cut; cutting takes about two kilobytes per pair.
inline constexpr std::size_t kMostPairsCombined = 2'000'000;
/// The default limit on the crossings that are computed, which take about a kilobyte each.
inline constexpr std::size_t kMostCrossingsCombined = 4'000'000;

struct CombineOptions {
  /// Rounding moves vertices by at most a share of this length; with 0 only to the nearest doubles.
  /// It is finite and not negative.
  double max_deviation = 0.0;
  /// The largest number of intersecting pairs of faces that are cut.
  std::size_t max_pairs = kMostPairsCombined;
  /// The largest number of times that the segments, along which a face meets others, cross each
  /// other inside it, added up over the faces: it grows with the square of the number of surfaces
  /// that pass through one place.
  std::size_t max_crossings = kMostCrossingsCombined;
  /// Called now and then, from any thread; the operation stops once it returns true.
  StopQuery wants_to_stop = {};
};

/// The outcome of a boolean operation.
enum class CombineOutcome : std::uint8_t {
  /// The exact search finds no faces of the result that intersect.
  Done,
  /// Faces of the result still intersect, because rounding made some intersect again and again. Of
  /// all rounds this is the result of the one that left the fewest pairs.
  Unfinished,
  /// Nothing was done, because more pairs of faces intersect than may be cut.
  TooManyPairs,
  /// Nothing was done, because the faces would be cut at more crossings, or at points of more
  /// digits, than may be computed.
  TooManyPoints,
  /// The operation was told to stop before it was done.
  Stopped,
};

/// A face of the result of a boolean operation.
struct CombinedFace {
  Triangle corners = kNoTriangle;
  /// The face of the soup that it is, or is a part of.
  Index origin = kNoIndex;
  /// Tells whether its orientation is opposite to that of its origin.
  bool is_turned = false;
  /// Tells whether faces of several operands cover it.
  bool is_common = false;
};

/// The result of a boolean operation.
struct CombinedSolid {
  CombineOutcome outcome = CombineOutcome::Done;
  /// The positions of the soup, used or not, of which some may be moved to a grid, followed by the
  /// new ones.
  std::vector<Vec3> positions;
  /// The faces, in order of their origins; empty if nothing is inside. A face that was not cut
  /// keeps the order of its corners unless it is reversed.
  std::vector<CombinedFace> faces;
  /// The number of intersecting pairs of faces of the operands, within one operand or between two.
  std::size_t n_pairs = 0;
  /// An upper bound of the distance by which rounding has moved any vertex.
  double largest_move = 0.0;
};

/// Combines solids to a new one and returns its boundary. All intersecting faces are cut along
/// their intersections, the exact winding number of every cell with respect to each operand is
/// found, and the pieces that separate cells inside by the rule from others are kept. The new
/// points are rounded to doubles, and this is repeated until no faces intersect. If it comes to no
/// end, it is tried again with the corners of intersecting faces moved to the points of a grid, if
/// the deviation permits that.
///
/// Operands may intersect themselves: a point is inside if the operand goes round it at least once.
/// Coplanar faces of several operands occur once in the result. Faces that meet no other are
/// unchanged to the bit. Parts of the result that touch along an edge or at a vertex share it, so
/// the result may be non-manifold. See doc/booleans.md.
///
/// @param operands  The operands, for none of which find_solid_fault() finds a fault.
/// @return          The result, which is the same for any number of threads.
/// @throws InvalidArgument  as build(); if there are no operands, or a face has none; if a position
/// is not finite; if the rule is null, or holds where all winding numbers are 0, so that the result
/// would have no end; and if the maximum deviation is no length.
/// @complexity      That of find_self_intersections(), plus O(#F) for the cells and O(#cells
///                  #operands).
[[nodiscard]] CombinedSolid combine_solids(const Operands& operands, const InsideRule& rule,
                                           const CombineOptions& options = {});

/// Returns the corners of a face of a result in the order of the face of the input that it is as a
/// whole: each at the place of that one's corner or, if the face is turned over, of the corner of
/// {0, 2, 1}. The vertices may be others, where some at one place became one.
///
/// @param source  The mesh that the face's origin counts in.
/// @return        Nothing if the face is a part of its origin, or of none.
[[nodiscard]] std::optional<Triangle> whole_face(const CombinedSolid& solid, const Soup& source,
                                                 const CombinedFace& face);

/// Returns the result of a boolean operation as a mesh, without unused vertices.
[[nodiscard]] Soup as_soup(const CombinedSolid& solid);

}  // namespace meshalyzer
