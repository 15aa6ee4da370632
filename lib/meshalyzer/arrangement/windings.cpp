#include "meshalyzer/arrangement/windings.h"

#include "meshalyzer/arrangement/exact_ray.h"

#include <utility>

namespace meshalyzer {
namespace {

/// Finds winding numbers component by component.
class WindingSearch {
 public:
  WindingSearch(const ArrangedSoup& arranged, std::span<const std::uint8_t> wanted)
      : a_(arranged), wanted_(wanted), pieces_(pieces_by_cell(arranged.cells)) {
    windings_.own.assign(a_.cells.count, 0);
    windings_.others.assign(a_.cells.n_components, 0);
    is_known_.assign(a_.cells.count, 0);
  }

  Windings run() {
    std::vector<std::uint8_t> done(a_.cells.n_components, 0);
    for (Index piece = 0; piece < a_.arrangement.pieces.size(); ++piece) {
      const Index component = a_.cells.component_of[piece];
      if (wanted_[component] == 0 || a_.cells.is_closed[component] == 0) continue;
      if (std::exchange(done[component], 1) != 0) continue;
      begin_at(piece);
      spread();
    }
    return std::move(windings_);
  }

 private:
  void begin_at(Index piece) {
    const PieceRay ray = follow_ray(a_, piece);
    const Index component = a_.cells.component_of[piece];
    int own = 0;
    for (const auto& [face, sign] : ray.crossings) {
      (a_.component_of_face(face) == component ? own : windings_.others[component]) += sign;
    }
    set(ray.cell, own);
  }

  void set(Index cell, int winding) {
    if (std::exchange(is_known_[cell], 1) != 0) return;
    windings_.own[cell] = winding;
    pending_.push_back(cell);
  }

  /// Propagates the numbers across pieces: behind each piece they are higher by its multiplicity.
  void spread() {
    while (!pending_.empty()) {
      const Index cell = pending_.back();
      pending_.pop_back();
      for (const Index piece : pieces_[cell]) {
        const int step = a_.arrangement.multiplicity(piece);
        if (a_.cells.front(piece) == cell) set(a_.cells.behind(piece), windings_.own[cell] + step);
        if (a_.cells.behind(piece) == cell) set(a_.cells.front(piece), windings_.own[cell] - step);
      }
    }
  }

  const ArrangedSoup& a_;
  std::span<const std::uint8_t> wanted_;
  ItemsByGroup pieces_;
  Windings windings_;
  std::vector<std::uint8_t> is_known_;
  std::vector<Index> pending_;
};

}  // namespace

Windings find_windings(const ArrangedSoup& arranged, std::span<const std::uint8_t> wanted) {
  return WindingSearch(arranged, wanted).run();
}

}  // namespace meshalyzer
