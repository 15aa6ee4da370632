#include "meshalyzer/boolean/internal/inside_cells.h"

#include "meshalyzer/arrangement/exact_ray.h"

#include <utility>

namespace meshalyzer {
namespace {

/// Traverses the cells depth first, so that only the winding numbers of one cell are kept.
class InsideSearch {
 public:
  InsideSearch(const ArrangedSoup& arranged, std::span<const Index> operand_of,
               std::size_t n_operands, const InsideRule& rule)
      : a_(arranged),
        operand_of_(operand_of),
        rule_(rule),
        pieces_(pieces_by_cell(arranged.cells)),
        windings_(n_operands, 0),
        is_known_(arranged.cells.count, 0),
        is_inside_(arranged.cells.count, 0) {}

  std::vector<std::uint8_t> run() {
    std::vector<std::uint8_t> done(a_.cells.n_components, 0);
    for (Index piece = 0; piece < a_.arrangement.pieces.size(); ++piece) {
      if (std::exchange(done[a_.cells.component_of[piece]], 1) != 0) continue;
      const PieceRay ray = follow_ray(a_, piece);
      add(ray, 1);
      walk_from(ray.cell);
      add(ray, -1);
    }
    return std::move(is_inside_);
  }

 private:
  /// A cell on the path, and the piece through which it was entered. Passing behind a piece raises
  /// the winding numbers of its faces' operands by one.
  struct Step {
    Index cell = kNoIndex;
    Index piece = kNoIndex;
    int direction = 1;
    std::size_t next = 0;
  };

  void add(const PieceRay& ray, int times) {
    for (const auto& [face, sign] : ray.crossings) windings_[operand_of_[face]] += times * sign;
  }

  void cross(Index piece, int direction) {
    for (const auto& [face, sign] : a_.arrangement.sources_of(piece)) {
      windings_[operand_of_[face]] += direction * sign;
    }
  }

  void walk_from(Index first) {
    decide(first);
    way_.push_back({.cell = first});
    while (!way_.empty()) {
      Step& step = way_.back();
      const std::span<const Index> pieces = pieces_[step.cell];
      if (step.next == pieces.size()) {
        if (step.piece != kNoIndex) cross(step.piece, -step.direction);
        way_.pop_back();
        continue;
      }
      const Index piece = pieces[step.next++];
      const bool is_in_front = a_.cells.front(piece) == step.cell;
      enter(is_in_front ? a_.cells.behind(piece) : a_.cells.front(piece), piece,
            is_in_front ? 1 : -1);
    }
  }

  void enter(Index cell, Index piece, int direction) {
    if (is_known_[cell] != 0) return;
    cross(piece, direction);
    decide(cell);
    way_.push_back({.cell = cell, .piece = piece, .direction = direction});
  }

  void decide(Index cell) {
    is_known_[cell] = 1;
    is_inside_[cell] = rule_(windings_) ? 1 : 0;
  }

  const ArrangedSoup& a_;
  std::span<const Index> operand_of_;
  const InsideRule& rule_;
  ItemsByGroup pieces_;
  /// The winding numbers of the last cell on the path.
  std::vector<int> windings_;
  std::vector<std::uint8_t> is_known_;
  std::vector<std::uint8_t> is_inside_;
  std::vector<Step> way_;
};

}  // namespace

std::vector<std::uint8_t> find_inside_cells(const ArrangedSoup& arranged,
                                            std::span<const Index> operand_of,
                                            std::size_t n_operands, const InsideRule& rule) {
  return InsideSearch(arranged, operand_of, n_operands, rule).run();
}

}  // namespace meshalyzer
