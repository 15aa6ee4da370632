#pragma once

#include "meshalyzer/boolean/inside_rule.h"
#include "meshalyzer/boolean/operands.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace meshalyzer {

/// Cutting takes about two kilobytes a pair.
inline constexpr std::size_t kMostPairsCombined = 2'000'000;

struct CombineOptions {
  /// Rounding moves vertices by a share of this length at most; 0: to the nearest doubles only.
  double max_deviation = 0.0;
  /// So many pairs of faces that intersect are cut, and no more.
  std::size_t max_pairs = kMostPairsCombined;
  /// Asked before each round; once it says yes the rest is left. May be empty.
  std::function<bool()> wants_to_stop = {};
};

/// Tells how a boolean operation has ended.
enum class CombineOutcome : std::uint8_t {
  /// The exact search finds no faces of the result that intersect.
  Done,
  /// Faces of the result still intersect: rounding made some do so again and again.
  Unfinished,
  /// Nothing was done, because more pairs of faces intersect than are cut.
  TooManyPairs,
  /// It was to stop before it was done.
  Stopped,
};

/// A face of the result of a boolean operation.
struct CombinedFace {
  Triangle corners{kNoIndex, kNoIndex, kNoIndex};
  /// The face of the soup that it is, or is a part of.
  Index origin = kNoIndex;
  /// Tells whether it looks the other way than that face.
  bool is_turned = false;
  /// Tells whether faces of several operands cover it.
  bool is_common = false;
};

/// The result of a boolean operation.
struct CombinedSolid {
  CombineOutcome outcome = CombineOutcome::Done;
  /// Those of the soup, whether they are used or not, and behind them those that were made.
  std::vector<Vec3> positions;
  /// In order of their origins. A face that was not cut has its corners in their order, but for
  /// being turned. Empty where nothing is inside.
  std::vector<CombinedFace> faces;
  /// Tells how many pairs of faces of the operands intersect, of one operand or of two.
  std::size_t n_pairs = 0;
  /// An upper bound of how far rounding has moved any vertex.
  double largest_move = 0.0;
};

/// Combines solids to a new one, whose boundary it is: cuts all faces that intersect along their
/// intersections, finds the winding number of every cell for each operand, exactly, keeps what
/// separates cells that are inside by the rule from others, and rounds the points that were made to
/// doubles, again and again until no faces intersect.
///
/// Operands may intersect themselves: inside is what they go round at least once. Coplanar faces of
/// several operands come out once. Faces that meet no other stay bit for bit. Where parts of the
/// result touch along an edge or at a vertex they have it in common, so that it may not be
/// manifold. See doc/booleans.md.
///
/// @param operands  Each without a fault that find_solid_fault() names.
/// @return          The same for any number of threads.
/// @throws InvalidArgument  if there are no operands, or a face has none, or a position is not
/// finite.
/// @complexity      As find_self_intersections(), O(#F) for cells, and O(#cells #operands).
[[nodiscard]] CombinedSolid combine_solids(const Operands& operands, const InsideRule& rule,
                                           const CombineOptions& options = {});

/// Returns the mesh that a boolean operation has made, without vertices that no face uses.
[[nodiscard]] Soup as_soup(const CombinedSolid& solid);

}  // namespace meshalyzer
