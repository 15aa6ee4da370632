#pragma once

#include "meshalyzer/boolean/combine_solids.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace meshalyzer {

/// What is left of a solid, moved off what was taken away from it.
struct PartedDifference {
  CombinedSolid solid;
  /// How many vertices were moved.
  std::size_t n_moved = 0;
  /// How far at most it was cut back where moving vertices did not part it from the others; 0 where
  /// that was not needed.
  double cut_back = 0.0;
  /// Tells whether it meets none of the others, and moving it off has made no faces intersect.
  bool is_apart = true;
};

/// Takes all other operands away from the first and moves what is left off them, see part_from().
/// Where that does not part them, as in a gap that is thinner than the steps, or makes faces of the
/// result intersect, the result is cut back by a small share of the maximum deviation.
///
/// @param others  What the other operands are now: as they were, or moved by little themselves.
/// @complexity    As combine_solids() and part_from(), up to eight times.
[[nodiscard]] PartedDifference subtract_and_part(const Operands& operands, const Soup& others,
                                                 const CombineOptions& options = {});

/// Subtracts from one of several solids those before it that it may meet.
///
/// @param number    The number of the solid.
/// @param operands  The solid, then those before it whose boxes meet its box, all as they were.
/// @param others    What has become of the latter, in one soup.
/// @return          What has become of the solid.
using SubtractStep =
    std::function<Soup(std::size_t number, const std::vector<Soup>& operands, const Soup& others)>;

/// Subtracts from each solid those before it, by one step for each in order, and returns the
/// results of the steps.
///
/// @throws InvalidArgument  if the step is null.
/// @complexity  O(n^2) tests of boxes, and the steps.
std::vector<Soup> subtract_in_order(std::span<const Soup> solids, const SubtractStep& subtract);

/// What has become of one of several solids that were made disjoint.
struct DisjointSolid {
  /// The solid without what is inside of those before it; empty where all of it is.
  Soup soup;
  /// Unless this is Done the soup is the solid as it was.
  CombineOutcome outcome = CombineOutcome::Done;
  /// An upper bound of how far any vertex was moved.
  double largest_move = 0.0;
  /// As in PartedDifference.
  bool is_apart = true;
};

/// Makes solids disjoint whose surfaces cross or touch, or of which one lies in another: each loses
/// what is inside of those before it, and is moved off them by the smallest step after which
/// check_pair() finds nothing, see subtract_and_part(); where none does, the result says so. The
/// first stays as it is, and so does each that meets none before it.
///
/// To make one solid of all, combine them by union_rule().
///
/// @param solids   Each without a fault that find_solid_fault() names.
/// @param options  Their max_deviation is also how far a vertex is moved at most: with 0 solids
///   keep touching where they have a wall in common.
/// @return         One for each solid; the same for any number of threads.
/// @throws InvalidArgument  where combine_solids() does, whether the solids meet or not.
/// @complexity     As subtract_and_part() for each solid, with those before it whose boxes it
/// meets.
[[nodiscard]] std::vector<DisjointSolid> make_disjoint(std::span<const Soup> solids,
                                                       const CombineOptions& options = {});

}  // namespace meshalyzer
