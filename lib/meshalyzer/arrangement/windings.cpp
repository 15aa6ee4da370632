#include "meshalyzer/arrangement/windings.h"

#include "meshalyzer/arrangement/exact_ray.h"

#include <utility>

namespace meshalyzer {

CellWindings::CellWindings(const Cells& cells)
    : cells_(cells),
      pieces_(pieces_by_cell(cells)),
      of_cell_(cells.count, 0),
      is_known_(cells.count, 0) {}

void CellWindings::spread_from(Index cell, int winding,
                               const std::function<int(Index piece)>& step) {
  set(cell, winding);
  while (!pending_.empty()) {
    const Index from = pending_.back();
    pending_.pop_back();
    for (const Index piece : pieces_[from]) {
      const int higher = step(piece);
      if (cells_.front(piece) == from) set(cells_.behind(piece), of_cell_[from] + higher);
      if (cells_.behind(piece) == from) set(cells_.front(piece), of_cell_[from] - higher);
    }
  }
}

void CellWindings::set(Index cell, int winding) {
  if (std::exchange(is_known_[cell], 1) != 0) return;
  of_cell_[cell] = winding;
  pending_.push_back(cell);
}

Windings find_windings(const ArrangedSoup& arranged, std::span<const std::uint8_t> wanted) {
  const Cells& cells = arranged.cells;
  CellWindings own(cells);
  Windings windings{.own = {}, .others = std::vector<int>(cells.n_components, 0)};
  std::vector<std::uint8_t> is_done(cells.n_components, 0);
  for (Index piece = 0; piece < arranged.arrangement.pieces.size(); ++piece) {
    const Index component = cells.component_of[piece];
    if (wanted[component] == 0 || cells.is_closed[component] == 0) continue;
    if (std::exchange(is_done[component], 1) != 0) continue;
    const PieceRay ray = follow_ray(arranged, piece);
    int winding = 0;
    for (const auto& [face, sign] : ray.crossings) {
      const bool is_own = arranged.component_of_face(face) == component;
      (is_own ? winding : windings.others[component]) += sign;
    }
    own.spread_from(ray.cell, winding,
                    [&](Index p) { return arranged.arrangement.multiplicity(p); });
  }
  windings.own = own.of_cell();
  return windings;
}

}  // namespace meshalyzer
