#include "meshalyzer/boolean/make_disjoint.h"

#include "meshalyzer/boolean/part_from.h"

#include <utility>

namespace meshalyzer {
namespace {

/// The box of all faces.
Box3 box_of_faces(const Soup& soup) {
  Box3 box;
  for (Index face = 0; face < soup.n_faces(); ++face) {
    if (!is_in_complex(soup.triangles[face])) continue;
    for (const Vec3& corner : corners_of(soup, face)) box.extend(corner);
  }
  return box;
}

}  // namespace

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

std::vector<DisjointSolid> make_disjoint(std::span<const Soup> solids,
                                         const CombineOptions& options) {
  std::vector<DisjointSolid> results;
  std::vector<Box3> boxes;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    boxes.push_back(box_of_faces(solids[i]));
    std::vector<Soup> operands{solids[i]};
    std::vector<Soup> others;
    for (std::size_t j = 0; j < i; ++j) {
      if (!boxes[i].intersects(boxes[j])) continue;
      operands.push_back(solids[j]);
      others.push_back(results[j].soup);
    }
    DisjointSolid& result = results.emplace_back();
    if (others.empty()) {
      result.soup = solids[i];
      continue;
    }
    const Soup all = concatenate(operands);
    const CombinedSolid solid =
        subtract_and_part(operands_of(all, operands), concatenate(others), options).solid;
    result.outcome = solid.outcome;
    const bool is_done = solid.outcome == CombineOutcome::Done;
    result.soup = is_done ? as_soup(solid) : solids[i];
    if (is_done) result.largest_move = solid.largest_move;
  }
  return results;
}

}  // namespace meshalyzer
