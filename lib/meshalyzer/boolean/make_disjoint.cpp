#include "meshalyzer/boolean/make_disjoint.h"

#include "meshalyzer/base/require.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/boolean/internal/padded_operands.h"
#include "meshalyzer/boolean/part_from.h"
#include "meshalyzer/mesh/finite_positions.h"
#include "meshalyzer/mesh/require_records.h"
#include "meshalyzer/mesh/used_box.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace meshalyzer {
namespace {

/// The thickness of pads, as a share of the maximum deviation: in each round twice as much as in
/// the one before, until it is 1/16.
constexpr double kLeastThickness = 1.0 / 256.0;
constexpr int kRoundsOfPads = 7;
constexpr int kRoundsOfGrowth = 4;
/// The largest distance by which vertices are moved at first, as a share of the maximum deviation;
/// pads do less harm than larger moves, after which thin parts intersect themselves.
constexpr double kFirstMove = 0x1p-18;
/// The same with pads, as a share of their thickness.
constexpr double kMoveOffPads = 1.0 / 16.0;

/// A difference, and how it was moved off the others.
struct Attempt {
  CombinedSolid solid;
  PartedVertices moved;
  /// How far at most the pads cut the solid back that were subtracted too.
  double cut_back = 0.0;

  /// An upper bound of how far the surface was moved.
  [[nodiscard]] double largest_move() const {
    return solid.largest_move + moved.largest_move + cut_back;
  }
};

/// Subtracts and moves, the first time without pads.
class DifferenceParting {
 public:
  DifferenceParting(const Operands& operands, const Soup& others, const CombineOptions& options)
      : operands_(operands), others_(others), options_(options) {}

  Attempt run() {
    Attempt best{combine_solids(operands_, difference_rule(), options_), {}};
    if (best.solid.outcome != CombineOutcome::Done) return best;
    best.moved = part(best.solid, kFirstMove * options_.max_deviation);
    std::vector<Index> blocking = best.moved.blocking;
    std::vector<Index> padded;
    for (int round = 0; round < kRoundsOfPads && !blocking.empty(); ++round) {
      if (options_.max_deviation == 0.0) break;
      padded.insert(padded.end(), blocking.begin(), blocking.end());
      sort_unique(padded);
      Attempt attempt = with_pads(padded, thickness_in_round(round));
      if (attempt.solid.outcome != CombineOutcome::Done) break;
      attempt.solid.n_pairs = best.solid.n_pairs;
      blocking = attempt.moved.blocking;
      const bool is_better = blocking.size() < best.moved.blocking.size();
      if (is_better && attempt.largest_move() <= options_.max_deviation) best = std::move(attempt);
    }
    return best;
  }

 private:
  [[nodiscard]] PartedVertices part(const CombinedSolid& solid, double max_move) const {
    return part_from(solid, operands_, others_, max_move);
  }

  [[nodiscard]] double thickness_in_round(int round) const {
    return std::ldexp(kLeastThickness * options_.max_deviation, std::min(round, kRoundsOfGrowth));
  }

  [[nodiscard]] Attempt with_pads(const std::vector<Index>& faces, double thickness) const {
    PaddedOperands padded(operands_);
    padded.add_pad(others_, faces, thickness);
    Attempt attempt{combine_solids(padded.operands(), PaddedOperands::rule(), options_),
                    {},
                    PaddedOperands::kMostPadding * thickness};
    if (attempt.solid.outcome == CombineOutcome::Done) {
      attempt.moved = part(attempt.solid, kMoveOffPads * thickness);
    }
    return attempt;
  }

  const Operands& operands_;
  const Soup& others_;
  const CombineOptions& options_;
};

}  // namespace

PartedDifference subtract_and_part(const Operands& operands, const Soup& others,
                                   const CombineOptions& options) {
  Attempt attempt = DifferenceParting(operands, others, options).run();
  const PartedVertices& moved = attempt.moved;
  const double largest_move = attempt.largest_move();
  PartedDifference result{std::move(attempt.solid), moved.vertices.size(), attempt.cut_back,
                          moved.blocking.empty()};
  result.solid.largest_move = largest_move;
  for (std::size_t i = 0; i < result.n_moved; ++i) {
    result.solid.positions[moved.vertices[i]] = moved.positions[i];
  }
  return result;
}

std::vector<Soup> subtract_in_order(std::span<const Soup> solids, const SubtractStep& subtract) {
  require_function("subtract_in_order: the step", subtract);
  std::vector<Soup> results;
  std::vector<Box3> boxes;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    boxes.push_back(used_box(solids[i]));
    std::vector<Soup> operands{solids[i]};
    std::vector<Soup> others;
    for (std::size_t j = 0; j < i; ++j) {
      if (!boxes[i].intersects(boxes[j])) continue;
      operands.push_back(solids[j]);
      others.push_back(results[j]);
    }
    results.push_back(subtract(i, operands, concatenate(others)));
  }
  return results;
}

std::vector<DisjointSolid> make_disjoint(std::span<const Soup> solids,
                                         const CombineOptions& options) {
  require_length("the maximum deviation", options.max_deviation);
  for (const Soup& solid : solids) {
    require_records(solid);
    require_finite_positions(solid);
  }
  std::vector<DisjointSolid> made(solids.size());
  std::vector<Soup> soups = subtract_in_order(
      solids, [&](std::size_t i, const std::vector<Soup>& operands, const Soup& others) {
        if (operands.size() == 1) return operands.front();
        const Soup all = concatenate(operands);
        const PartedDifference left =
            subtract_and_part(operands_of(all, operands), others, options);
        const CombinedSolid& solid = left.solid;
        made[i].outcome = solid.outcome;
        if (solid.outcome != CombineOutcome::Done) return operands.front();
        made[i].largest_move = solid.largest_move;
        made[i].is_apart = left.is_apart;
        return as_soup(solid);
      });
  for (std::size_t i = 0; i < made.size(); ++i) made[i].soup = std::move(soups[i]);
  return made;
}

}  // namespace meshalyzer
