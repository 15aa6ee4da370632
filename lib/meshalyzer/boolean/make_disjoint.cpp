#include "meshalyzer/boolean/make_disjoint.h"

#include "meshalyzer/boolean/part_from.h"
#include "meshalyzer/mesh/used_box.h"

#include <utility>

namespace meshalyzer {
PartedDifference subtract_and_part(const Operands& operands, const Soup& others,
                                   const CombineOptions& options) {
  PartedDifference result{combine_solids(operands, difference_rule(), options), 0};
  if (result.solid.outcome != CombineOutcome::Done) return result;
  const PartedVertices moved = part_from(result.solid, operands, others, options.max_deviation);
  for (std::size_t i = 0; i < moved.vertices.size(); ++i) {
    result.solid.positions[moved.vertices[i]] = moved.positions[i];
  }
  result.solid.largest_move += moved.largest_move;
  result.n_moved = moved.vertices.size();
  return result;
}

std::vector<Soup> subtract_in_order(std::span<const Soup> solids, const SubtractStep& subtract) {
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
  std::vector<DisjointSolid> made(solids.size());
  std::vector<Soup> soups = subtract_in_order(
      solids, [&](std::size_t i, const std::vector<Soup>& operands, const Soup& others) {
        if (operands.size() == 1) return operands.front();
        const Soup all = concatenate(operands);
        const CombinedSolid solid =
            subtract_and_part(operands_of(all, operands), others, options).solid;
        made[i].outcome = solid.outcome;
        if (solid.outcome != CombineOutcome::Done) return operands.front();
        made[i].largest_move = solid.largest_move;
        return as_soup(solid);
      });
  for (std::size_t i = 0; i < made.size(); ++i) made[i].soup = std::move(soups[i]);
  return made;
}

}  // namespace meshalyzer
