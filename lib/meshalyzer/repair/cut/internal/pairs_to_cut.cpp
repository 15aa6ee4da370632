#include "meshalyzer/repair/cut/internal/pairs_to_cut.h"

#include "meshalyzer/arrangement/arrange.h"
#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/repair/cut/internal/select_pieces.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace meshalyzer {
namespace {

using Pairs = std::vector<IntersectingPair>;

/// Marks the faces of closed parts that overlap although these pairs only meet at copies of
/// vertices.
std::vector<std::uint8_t> faces_that_overlap(const Soup& soup, const CutMesh& cut,
                                             const FaceTree& tree, const Pairs& pairs) {
  std::vector<std::uint8_t> overlaps(soup.n_faces(), 0);
  if (pairs.empty()) return overlaps;
  const Arrangement arrangement = arrange(soup, pairs);
  const Cells cells = find_cells(soup, arrangement);
  const ArrangedSoup arranged{soup, cut, tree, arrangement, cells};
  const std::vector<PieceClass> classes = select_pieces(arranged, cells.is_closed, {});
  std::vector<std::uint8_t> has_wall(cells.n_components, 0);
  for (std::size_t piece = 0; piece < classes.size(); ++piece) {
    if (classes[piece] == PieceClass::Interior) has_wall[cells.component_of[piece]] = 1;
  }
  for (Index face = 0; face < soup.n_faces(); ++face) {
    const Index component = arranged.component_of_face(face);
    if (component != kNoIndex) overlaps[face] = has_wall[component];
  }
  return overlaps;
}

}  // namespace

Pairs pairs_to_cut(const Soup& soup, const CutMesh& cut, const FaceTree& tree, Pairs pairs) {
  DisjointSets groups(soup.n_faces());
  for (const IntersectingPair& pair : pairs) groups.unite(pair.face_a, pair.face_b);
  std::vector<std::uint8_t> is_more(soup.n_faces(), 0);
  for (const IntersectingPair& pair : pairs) {
    if (pair.kind != ContactKind::Unwelded) is_more[groups.find(pair.face_a)] = 1;
  }
  Pairs unwelded;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(unwelded),
               [&](const auto& pair) { return is_more[groups.find(pair.face_a)] == 0; });
  const std::vector<std::uint8_t> overlaps = faces_that_overlap(soup, cut, tree, unwelded);
  std::erase_if(pairs, [&](const IntersectingPair& pair) {
    return is_more[groups.find(pair.face_a)] == 0 && overlaps[pair.face_a] == 0;
  });
  return pairs;
}

}  // namespace meshalyzer
