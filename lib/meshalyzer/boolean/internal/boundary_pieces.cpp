#include "meshalyzer/boolean/internal/boundary_pieces.h"

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

std::vector<BoundaryPiece> find_boundary_pieces(const ArrangedSoup& arranged,
                                                std::span<const Index> operand_of,
                                                std::size_t n_operands, const InsideRule& rule) {
  const Arrangement& a = arranged.arrangement;
  const Cells& cells = arranged.cells;
  const std::vector<std::uint8_t> is_inside =
      find_inside_cells(arranged, operand_of, n_operands, rule);
  std::vector<BoundaryPiece> boundary;
  for (Index piece = 0; piece < a.pieces.size(); ++piece) {
    const bool is_front_inside = is_inside[cells.front(piece)] != 0;
    if (is_front_inside == (is_inside[cells.behind(piece)] != 0)) continue;
    // The faces of a reversed operand have the opposite orientation in the result.
    const auto sources = a.sources_of(piece);
    boundary.push_back({piece, face_that_faces(sources, is_front_inside), is_front_inside});
  }
  return boundary;
}

}  // namespace meshalyzer
