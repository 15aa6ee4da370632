#include "meshalyzer/boolean/internal/exact_solid.h"

#include "meshalyzer/arrangement/arrange.h"
#include "meshalyzer/arrangement/cells.h"
#include "meshalyzer/boolean/internal/inside_cells.h"

#include <cstdint>

namespace meshalyzer {
namespace {

/// Returns the first of the faces covering a piece that has the orientation of the piece in the
/// result.
Index face_that_faces(std::span<const PieceSource> sources, bool is_turned) {
  const Sign wanted = is_turned ? -1 : 1;
  for (const PieceSource& source : sources) {
    if (source.sign == wanted) return source.face;
  }
  return sources.front().face;
}

}  // namespace

ExactSolid find_exact_solid(const IntersectingSoup& input, std::span<const Index> operand_of,
                            std::size_t n_operands, const InsideRule& rule) {
  ExactSolid solid{arrange(input.soup, input.pairs), {}};
  const Arrangement& a = solid.arrangement;
  const Cells cells = find_cells(input.soup, a);
  const std::vector<std::uint8_t> is_inside = find_inside_cells(
      {input.soup, input.cut, input.tree, a, cells}, operand_of, n_operands, rule);
  for (Index piece = 0; piece < a.pieces.size(); ++piece) {
    const bool is_front_inside = is_inside[cells.front(piece)] != 0;
    if (is_front_inside == (is_inside[cells.behind(piece)] != 0)) continue;
    // The faces of a reversed operand have the opposite orientation in the result.
    const auto sources = a.sources_of(piece);
    solid.boundary.push_back({piece, face_that_faces(sources, is_front_inside), is_front_inside});
  }
  return solid;
}

}  // namespace meshalyzer
