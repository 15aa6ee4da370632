#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/split/cut_stars.h"
#include "meshalyzer/repair/split/vertex_stars.h"
#include "meshalyzer/topology/disjoint_sets.h"
#include "meshalyzer/topology/manifold.h"

#include <utility>

namespace meshalyzer {
namespace {

/// Leaves fans at an edge with more than two faces apart: pinched vertices have none.
std::vector<Index> join_none(std::span<const Spoke> edge) {
  return std::vector<Index>(edge.size(), kNoIndex);
}

}  // namespace

PassResult split_vertices(const PassInput& input) {
  PassResult result;
  std::vector<Index> pinched;
  for (const Index v : find_pinched_vertices(input.mesh.cut())) {
    if (input.limits.groups == Groups::Faces && input.limits.is_fixed(input.draft, v)) {
      result.refused.push_back(
          {.code = DefectCode::NonManifold,
           .vertex = v,
           .reason = "the border of a face of the body would get more vertices"});
    } else {
      pinched.push_back(v);
    }
  }
  if (pinched.empty()) return result;

  const Soup& soup = input.mesh.soup();
  const VertexStars stars(input.mesh.cut(), std::move(pinched));
  std::vector<Index> fans;
  for (std::size_t star = 0; star < stars.size(); ++star) {
    const std::vector<Index> of_star = find_fans_of_star(soup, stars, star, join_none);
    fans.insert(fans.end(), of_star.begin(), of_star.end());
  }
  result.edits = cut_stars(soup, stars, fans, DisjointSets(stars.size()));
  return result;
}

}  // namespace meshalyzer
