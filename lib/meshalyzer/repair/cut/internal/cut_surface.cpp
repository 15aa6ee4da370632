#include "meshalyzer/repair/cut/internal/cut_surface.h"

#include "meshalyzer/repair/cut/internal/cutting_rounds.h"

#include <cstddef>
#include <span>
#include <utility>

namespace meshalyzer {
namespace {

/// Pockets are dropped if they have at most this fraction of the area that stays.
constexpr double kLargestForgotten = 0.25;

CuttingRounds cut_without_slivers(CuttingRounds rounds, Slivers slivers) {
  rounds.remove_slivers_of_rounds(slivers);
  rounds.cut_to_end();
  return rounds;
}

/// Cuts on to the end. If rounding makes faces intersect again and again, slivers are removed:
/// their planes turn in any direction. Where slivers are to widen, nothing else has sufficed.
CuttingRounds cut_on_grid(CuttingRounds rounds, Slivers slivers) {
  if (!rounds.has_pairs()) return rounds;
  if (slivers == Slivers::Widening) return cut_without_slivers(std::move(rounds), slivers);
  CuttingRounds with_slivers = rounds;
  with_slivers.cut_to_end();
  if (with_slivers.is_finished()) return with_slivers;
  CuttingRounds without = cut_without_slivers(std::move(rounds), slivers);
  return without.is_finished() ? without : with_slivers;
}

/// Removes thin facets that cutting has made, unless faces then intersect again and again.
CuttingRounds without_thin_facets(CuttingRounds rounds) {
  if (!rounds.is_finished()) return rounds;
  CuttingRounds without = rounds;
  return without.remove_thin_facets() ? without : rounds;
}

/// Tells whether a surface is whole but for its pockets, which may be dropped.
bool may_forget_pockets(const CuttingRounds& rounds) {
  return rounds.is_finished() && rounds.pocket_share() <= kLargestForgotten;
}

}  // namespace

CutSurface cut_surface(const PassInput& input, const ChangesBefore& changes,
                       const SelectOptions& options, const PieceRules& rules) {
  CuttingRounds first(input, changes, options, rules.more_pieces);
  first.cut_off_grid();
  CuttingRounds rounds = cut_on_grid(std::move(first), Slivers::OfGrid);
  if (rules.thin_facets == ThinFacets::Kept) return rounds.take_result();
  return without_thin_facets(std::move(rounds)).take_result();
}

CutSurface cut_keeping_pockets(const PassInput& input, const ChangesBefore& changes, Sheets sheets,
                               std::size_t more_pieces) {
  // Pockets matter only once the faces are cut.
  FirstCut first_cut;
  CuttingRounds with_pockets(input, changes, {Pockets::Kept, sheets}, more_pieces, &first_cut);
  with_pockets.cut_off_grid();
  CuttingRounds first = cut_on_grid(with_pockets, Slivers::OfGrid);
  if (first.is_finished() || first.has_too_many_pieces()) return first.take_result();
  CuttingRounds solid(input, changes, {Pockets::Forgotten, sheets}, more_pieces, &first_cut);
  solid.cut_off_grid();
  first_cut.reset();
  if (CuttingRounds rounds = cut_on_grid(solid, Slivers::OfGrid); may_forget_pockets(rounds)) {
    return rounds.take_result();
  }
  CuttingRounds wide = cut_on_grid(std::move(with_pockets), Slivers::Widening);
  if (wide.is_finished()) return wide.take_result();
  CuttingRounds wide_solid = cut_on_grid(std::move(solid), Slivers::Widening);
  return may_forget_pockets(wide_solid) ? wide_solid.take_result() : first.take_result();
}

}  // namespace meshalyzer
