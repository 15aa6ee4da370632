#include "meshalyzer/repair/cut/internal/select_pieces.h"

#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/repair/cut/internal/closed_part.h"
#include "meshalyzer/repair/cut/internal/estimated_windings.h"

#include <array>
#include <utility>

namespace meshalyzer {
namespace {

/// Cells with a larger estimated winding number are certainly inside.
constexpr double kSurelyInside = 0.75;

/// A component with a larger fraction of its area outside of the solid bounds none.
constexpr double kMostFlaps = 0.25;

/// The rule for the inside of a closed component.
enum class Rule : std::uint8_t {
  /// The region with a total winding number of at least one: a component inside others is a cavity.
  InAll,
  /// The region with a winding number of the component itself of at least one.
  Own,
  /// The region with any non-zero winding number of the component.
  OwnEitherWay,
};

/// Decides component by component which cells are inside.
class PieceSelection {
 public:
  PieceSelection(const ArrangedSoup& arranged, std::span<const std::uint8_t> is_cut,
                 const SelectOptions& options)
      : a_(arranged),
        cells_(arranged.cells),
        pockets_(options.pockets),
        sheets_(options.sheets),
        wants_to_stop_(options.wants_to_stop),
        classes_(arranged.arrangement.pieces.size(), PieceClass::Kept) {
    is_closed_.assign(cells_.n_components, 0);
    is_open_.assign(cells_.n_components, 0);
    for (std::size_t c = 0; c < cells_.n_components; ++c) {
      (cells_.is_closed[c] != 0 ? is_closed_ : is_open_)[c] = is_cut[c];
    }
  }

  std::vector<PieceClass> run() {
    select_exactly();
    closed_ = find_closed_part(a_, is_open_);
    select_sheets(sheets_ == Sheets::Cut ? closed_.tells_inside : closed_.encloses_rest);
    select_by_estimates();
    if (sheets_ == Sheets::Cut) {
      select_sheets(std::vector(is_open_));
    } else {
      leave_open();
    }
    return std::move(classes_);
  }

 private:
  /// No component is lost: if one rule keeps nothing of it, the next one is tried, and if none
  /// keeps anything, all of it stays.
  void select_exactly() {
    const Windings windings = find_windings(a_, is_closed_);
    std::vector<std::uint8_t> pending = is_closed_;
    for (const Rule rule : {Rule::InAll, Rule::Own, Rule::OwnEitherWay}) {
      decide(pending, [&](Index component, Index cell) {
        return is_inside(windings, rule, component, cell);
      });
      const std::vector<std::uint8_t> is_kept = components_kept();
      for (std::size_t c = 0; c < pending.size(); ++c) {
        if (is_kept[c] != 0) pending[c] = 0;
      }
    }
    keep_all(pending);
    // In a cavity, the outside is known.
    for (std::size_t piece = 0; piece < classes_.size(); ++piece) {
      const bool is_cavity = windings.others[cells_.component_of[piece]] > 0;
      PieceClass& piece_class = classes_[piece];
      if (is_cavity && piece_class == PieceClass::Exterior) piece_class = PieceClass::Cancelled;
    }
  }

  /// #components: 1 for those of which something stays.
  [[nodiscard]] std::vector<std::uint8_t> components_kept() const {
    std::vector<std::uint8_t> is_kept(cells_.n_components, 0);
    for (std::size_t piece = 0; piece < classes_.size(); ++piece) {
      const bool stays =
          classes_[piece] == PieceClass::Kept || classes_[piece] == PieceClass::Turned;
      if (stays) is_kept[cells_.component_of[piece]] = 1;
    }
    return is_kept;
  }

  [[nodiscard]] bool is_inside(const Windings& windings, Rule rule, Index component,
                               Index cell) const {
    const int own = windings.own[cell];
    const int around = rule == Rule::InAll && windings.others[component] > 0 ? 1 : 0;
    const bool either_way = rule == Rule::OwnEitherWay || pockets_ == Pockets::Kept;
    // If cavities overlap, the whole region is a cavity.
    return own + around > 0 || (either_way && around == 0 && own < 0);
  }

  void decide_by_closed_part(const std::vector<std::uint8_t>& components, Pockets pockets) {
    decide(components, [&](Index, Index cell) {
      const int winding = closed_.windings[cell];
      return winding >= 1 || (pockets == Pockets::Kept && winding < 0);
    });
  }

  void select_by_estimates() {
    const EstimatedWindings windings = estimate_windings(a_, is_open_, wants_to_stop_);
    std::vector<std::uint8_t> solid = is_open_;
    for (std::size_t c = 0; c < solid.size(); ++c) {
      if (windings.bounds_solid[c] == 0) solid[c] = 0;
    }
    decide(solid, [&](Index, Index cell) { return windings.of_cell[cell] >= 0.5; });
    const std::vector<std::uint8_t> is_kept = components_kept();
    for (std::size_t c = 0; c < solid.size(); ++c) {
      // No component is lost.
      if (is_kept[c] == 0) solid[c] = 0;
    }
    for (std::size_t piece = 0; piece < classes_.size(); ++piece) {
      const bool is_sure = windings.of_cell[cells_.front(piece)] >= kSurelyInside &&
                           windings.of_cell[cells_.behind(piece)] >= kSurelyInside;
      if (solid[cells_.component_of[piece]] == 0) continue;
      const bool is_unsure = classes_[piece] == PieceClass::Interior && !is_sure;
      if (is_unsure || classes_[piece] == PieceClass::Exterior) {
        classes_[piece] = PieceClass::PerhapsExterior;
      }
    }
    if (sheets_ == Sheets::Cut) leave_those_with_flaps(solid);
    for (std::size_t c = 0; c < is_open_.size(); ++c) {
      if (solid[c] != 0) is_open_[c] = 0;
    }
  }

  /// Leaves components of which much lies outside of the region that they enclose: they only seem
  /// to bound a solid, as sheets do that lie one over the other.
  void leave_those_with_flaps(std::vector<std::uint8_t>& components) const {
    std::vector<double> area(cells_.n_components, 0.0);
    std::vector<double> area_of_flaps(cells_.n_components, 0.0);
    for (std::size_t piece = 0; piece < classes_.size(); ++piece) {
      const Index component = cells_.component_of[piece];
      if (components[component] == 0) continue;
      const double size = normal_of(a_.arrangement.corners_of(piece)).norm();
      area[component] += size;
      if (classes_[piece] == PieceClass::PerhapsExterior) area_of_flaps[component] += size;
    }
    for (std::size_t c = 0; c < components.size(); ++c) {
      if (area_of_flaps[c] > kMostFlaps * area[c]) components[c] = 0;
    }
  }

  /// Selects from components of sheets, and of solids that they cross.
  void select_sheets(const std::vector<std::uint8_t>& components) {
    decide_by_closed_part(components, pockets_);
    const std::vector<std::uint8_t> is_kept = components_kept();
    std::vector<std::uint8_t> inside_out = components;
    for (std::size_t c = 0; c < components.size(); ++c) {
      if (is_kept[c] != 0) inside_out[c] = 0;
    }
    decide_by_closed_part(inside_out, Pockets::Kept);
    for (std::size_t piece = 0; piece < classes_.size(); ++piece) {
      const Index component = cells_.component_of[piece];
      if (components[component] == 0 || closed_.is_of_chain[piece] != 0) continue;
      if (classes_[piece] == PieceClass::Interior) continue;
      classes_[piece] = closed_.is_loose[component] != 0 ? PieceClass::Loose : PieceClass::OfSheet;
    }
    for (std::size_t c = 0; c < components.size(); ++c) {
      if (components[c] != 0) is_open_[c] = 0;
    }
  }

  void leave_open() {
    for (std::size_t piece = 0; piece < classes_.size(); ++piece) {
      if (is_open_[cells_.component_of[piece]] != 0) classes_[piece] = PieceClass::Uncut;
    }
  }

  template <typename IsInside>
  void decide(const std::vector<std::uint8_t>& components, const IsInside& is_inside) {
    for (std::size_t piece = 0; piece < classes_.size(); ++piece) {
      const Index component = cells_.component_of[piece];
      if (components[component] == 0) continue;
      classes_[piece] = class_of(piece, is_inside(component, cells_.front(piece)),
                                 is_inside(component, cells_.behind(piece)));
    }
  }

  [[nodiscard]] PieceClass class_of(std::size_t piece, bool is_front_inside,
                                    bool is_inside_behind) const {
    if (is_front_inside != is_inside_behind) {
      return is_inside_behind ? PieceClass::Kept : PieceClass::Turned;
    }
    if (is_front_inside) return PieceClass::Interior;
    return a_.arrangement.multiplicity(piece) == 0 ? PieceClass::Cancelled : PieceClass::Exterior;
  }

  void keep_all(const std::vector<std::uint8_t>& components) {
    for (std::size_t piece = 0; piece < classes_.size(); ++piece) {
      if (components[cells_.component_of[piece]] != 0) classes_[piece] = PieceClass::Kept;
    }
  }

  const ArrangedSoup& a_;
  const Cells& cells_;
  Pockets pockets_;
  Sheets sheets_;
  const StopQuery& wants_to_stop_;
  ClosedPart closed_;
  /// #components: 1 for those whose pieces are still to be selected.
  std::vector<std::uint8_t> is_closed_;
  std::vector<std::uint8_t> is_open_;
  std::vector<PieceClass> classes_;
};

}  // namespace

std::vector<PieceClass> select_pieces(const ArrangedSoup& arranged,
                                      std::span<const std::uint8_t> is_cut,
                                      const SelectOptions& options) {
  return PieceSelection(arranged, is_cut, options).run();
}

}  // namespace meshalyzer
