#include "meshalyzer/repair/guarantee/internal/guarantee.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/repair/guarantee/internal/unite_from_input.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/replace/internal/broken_solids.h"
#include "meshalyzer/repair/replace/internal/replacements.h"
#include "meshalyzer/repair/rules/internal/fixed_vertices.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>

namespace meshalyzer {
namespace {

/// What replaces a part of the mesh needs this share of the maximum deviation. With less a thin
/// solid would hardly have a thickness, and a grid for a contour would hardly ever suffice.
constexpr double kLeastShareLeft = 1.0 / 64.0;
/// A union with shells may lose other parts; so often it is tried with more or thinner ones.
constexpr std::size_t kMostUnionsWithShells = 5;
/// Where many shells lie above each other, thinner ones have this share of the thickness.
constexpr double kThinner = 0.25;

/// If no union is good, broken parts are moved outward by this share of the maximum deviation, and
/// at most four times as far, before one is tried again.
constexpr double kOffsetShare = 1.0 / 16.0;

/// The thickness of solids made of sheets, as a fraction of the deviation that is left.
constexpr std::array<double, 3> kSharesOfThickness{0.5, 0.05, 0.005};

void add_keys(const std::vector<Index>& added, std::vector<Index>& keys) {
  keys.insert(keys.end(), added.begin(), added.end());
  sort_unique(keys);
}

class Guarantee {
 public:
  Guarantee(RepairDriver& driver, const RepairOptions& options)
      : driver_(driver),
        options_(options),
        tolerances_(driver.mesh().tolerances()),
        max_deviation_(driver.mesh().max_deviation()) {}

  std::vector<std::string> run() {
    if (driver_.is_good(driver_.mesh().state())) return {};
    if (driver_.mesh().tracked().soup.n_faces() == 0) {
      return {"no solid: there is no face to make one from"};
    }
    if (!(max_deviation_ > 0.0)) {
      return {"not replaced: a replacement needs a maximum deviation above 0"};
    }
    if (has_borders_to_keep()) {
      return {
          "not good, and not replaced: a new surface would not have the borders that are to be "
          "kept"};
    }
    // A new surface, which would keep what is behind holes, needs a part of the deviation.
    const bool may_replace =
        max_deviation_ - driver_.mesh().deviation() >= kLeastShareLeft * max_deviation_;
    const auto behind_holes =
        options_.solid && !may_replace ? BehindHoles::Dropped : BehindHoles::Kept;
    const bool is_done =
        (options_.solid && may_replace && thicken()) || unite({.behind_holes = behind_holes}) ||
        join() || unite_moved_outward(behind_holes) ||
        (may_drop_after_all() ? make_new_surface(may_replace) || unite_with_shells()
                              : unite_with_shells() || make_new_surface(may_replace));
    if (!is_done) note_failure();
    return std::move(notes_);
  }

 private:
  /// Tells whether there are intended borders, or common borders of the faces of a body.
  [[nodiscard]] bool has_borders_to_keep() const {
    const MeasuredMesh& mesh = driver_.mesh();
    const std::vector<std::uint8_t> fixed =
        find_fixed_vertices(mesh.tracked(), mesh.prepared().cut(), options_);
    return std::find(fixed.begin(), fixed.end(), 1) != fixed.end();
  }

  /// Tells whether a contour of the whole mesh may serve where one of the broken parts did not: it
  /// cannot if they are all of the mesh, or if their grid was too large.
  [[nodiscard]] bool may_replace_more() const {
    if (needs_larger_grid_) return false;
    const std::vector<BrokenSolid> solids = find_broken_solids(driver_.mesh().prepared());
    return solids.size() != 1 ||
           solids.front().faces.size() != driver_.mesh().prepared().cut().side.faces.size();
  }

  /// Keeps the result of a pass, and of a plan after it, if it is good; counts the pairs of its
  /// faces that intersect.
  ///
  /// @param from_input  If there are any, the trial starts from the input with these passes.
  bool try_pass(const PlannedPass& pass, std::vector<PlannedPass> plan,
                std::vector<PlannedPass> from_input = {}) {
    n_pairs_of_trial_ = 0;
    return driver_.run_trial({.from_input = std::move(from_input),
                              .changes = {pass},
                              .plan = std::move(plan),
                              .is_wanted = [&](const RepairState& state) {
                                n_pairs_of_trial_ = state.mesh().intersecting_pairs().size();
                                return driver_.is_good(state);
                              }});
  }

  /// Tells whether a union failed only because parts behind holes were kept.
  [[nodiscard]] bool may_drop_after_all() const {
    return options_.solid && union_memory_.with_parts_dropped;
  }

  /// Takes this union after all.
  bool drop_behind_holes() {
    if (!may_drop_after_all()) return false;
    const auto& [made, deviation, note] = *union_memory_.with_parts_dropped;
    driver_.return_to(made);
    driver_.mesh().raise_deviation(deviation);
    notes_.push_back(note);
    return true;
  }

  /// Makes thin solids of sheets, if the mesh consists of sheets only.
  ///
  /// If the last of them is not good, remembers how often it intersects itself.
  bool thicken() {
    const double left = max_deviation_ - driver_.mesh().deviation();
    const bool do_sheets_intersect = !driver_.mesh().prepared().intersecting_pairs().empty();
    // Thinner solids are tried in case thick ones intersect where the sheets do not.
    const std::size_t n_tries = do_sheets_intersect ? 1 : kSharesOfThickness.size();
    for (const double share : std::span(kSharesOfThickness).first(n_tries)) {
      const double thickness = share * left;
      const PlannedPass pass{"thicken sheets", DefectCode::Hole, [&](const PassInput& input) {
                               return thicken_sheets(input, thickness);
                             }};
      if (!try_pass(pass, plan_with_contacts_joined(options_, tolerances_))) {
        n_pairs_of_thin_solid_ = n_pairs_of_trial_;
        continue;
      }
      driver_.mesh().raise_deviation(thickness / 2.0);
      notes_.push_back("a surface that encloses nothing was made a solid " + readable(thickness) +
                       " thick");
      return true;
    }
    return false;
  }

  /// Joins what touches and cannot be parted, if nothing else is wrong.
  bool join() {
    const std::vector<PlannedPass> joining = plan_to_join_contacts(options_);
    if (joining.empty()) return false;
    const bool is_kept = driver_.run_trial(
        {.changes = joining,
         .plan = plan_passes(options_, tolerances_),
         .is_wanted = [&](const RepairState& state) {
           return driver_.is_good(state) && driver_.mesh().measure_deviation() <= max_deviation_;
         }});
    if (is_kept) notes_.emplace_back("what touched, and could not be parted, was joined there");
    return is_kept;
  }

  bool unite(UnionChoice choice) {
    choice.offset_share = offset_share_;
    UnitedFromInput united = unite_from_input(driver_, options_, choice, union_memory_);
    is_union_too_far_ = united.is_too_far;
    lost_ = std::move(united.lost);
    if (united.note.empty()) return false;
    notes_.push_back(std::move(united.note));
    return true;
  }

  /// If no union was good, unites the mesh after broken parts were moved outward, and so do all
  /// unions from then on.
  bool unite_moved_outward(BehindHoles behind_holes) {
    if (is_union_too_far_) return false;
    offset_share_ = kOffsetShare;
    return unite({.behind_holes = behind_holes});
  }

  /// If a union was good but too far away, unites the mesh again, and keeps as thin shells the open
  /// parts that it has lost; then also those whose hole patches may have hidden what was lost; then
  /// again, with closed parts too, and thinner, in case so many lay above each other that they hid
  /// it. In the last attempt what is still lost inside the solid does not count.
  bool unite_with_shells() {
    if (!options_.solid) return false;
    ShellChoice shells;
    for (std::size_t i = 0; i < kMostUnionsWithShells && is_union_too_far_; ++i) {
      const auto& [face_keys, shell_keys, has_open, points] = lost_;
      // With the same shells it would end as before.
      if (i > 0 && points.empty()) return false;
      add_keys(face_keys, shells.face_keys);
      // Faces of shells that the second union has lost, too, may have turned over in them.
      if (i > 1) add_keys(shell_keys, shells.separable_keys);
      if (i > 0 && !has_open) {
        if (!shells.hidden_points.empty()) {
          shells.thickness_share *= kThinner;
          shells.closed_too = true;
        }
        shells.hidden_points.insert(shells.hidden_points.end(), points.begin(), points.end());
      }
      const bool is_last = i + 1 == kMostUnionsWithShells;
      const auto behind_holes = is_last ? BehindHoles::Dropped : BehindHoles::Kept;
      if (unite({.behind_holes = behind_holes, .shells = shells})) return true;
    }
    return false;
  }

  /// Tells whether everything that is broken means a solid.
  [[nodiscard]] bool bounds_solids() const {
    const std::vector<BrokenSolid> solids = find_broken_solids(driver_.mesh().prepared());
    return std::all_of(solids.begin(), solids.end(), [&](const BrokenSolid& solid) {
      return solid.any_bounds_solid && (solid.all_bound_solid || options_.solid);
    });
  }

  enum class Outcome : std::uint8_t { Kept, NotGood, NotProposed };

  /// A replacement, and the passes after it.
  struct Trial {
    std::string_view name;
    /// Gets the mesh, and what is left of the maximum deviation.
    std::function<Replacement(const PassInput&, double)> propose;
    std::vector<PlannedPass> plan;
    /// If there are any, the replacement starts from the input with these passes.
    std::vector<PlannedPass> from_input = {};
  };

  /// Replaces what is broken by a new surface: as little as possible first, in the end all of the
  /// input. Before that, a union may be taken that drops parts behind holes.
  ///
  /// @param may_replace  Tells whether what the passes have left may be replaced.
  bool make_new_surface(bool may_replace) {
    using Scope = ReplaceOptions::Scope;
    return (may_replace &&
            (replace_in_boxes() || replace(Scope::Broken) ||
             (may_replace_more() && replace(Scope::Whole)) || drop_behind_holes())) ||
           replace_from_input();
  }

  /// Replaces what lies in boxes round the broken places, first in small ones.
  bool replace_in_boxes() {
    if (!bounds_solids()) return false;
    for (const double margin : {2.0 * max_deviation_, 16.0 * max_deviation_}) {
      BoxOptions how{.margin = margin,
                     .lost = options_.solid ? LostParts::Allowed : LostParts::Refused};
      const auto propose = [&](const PassInput& input, double left) {
        how.max_deviation = left;
        return meshalyzer::replace_in_boxes(input, how);
      };
      const Outcome outcome = try_replacement(
          {"replace in boxes", propose, plan_with_contacts_joined(options_, tolerances_)});
      if (outcome != Outcome::NotGood) return outcome == Outcome::Kept;
    }
    return false;
  }

  /// Replaces the broken parts, or all of the mesh.
  bool replace(ReplaceOptions::Scope scope) {
    return Outcome::Kept == try_replacement({"replace broken solids", contour_of(scope),
                                             plan_after_replacement(options_)});
  }

  /// Replaces all of the input, where repairs have used up much of the deviation and left it broken
  /// all the same.
  bool replace_from_input() {
    constexpr double kMuch = 0.25;
    if (driver_.mesh().deviation() < kMuch * max_deviation_ || driver_.is_stopped()) return false;
    return Outcome::Kept ==
           try_replacement({"replace broken solids", contour_of(ReplaceOptions::Scope::Whole),
                            plan_after_replacement(options_),
                            plan_before_contour(options_, tolerances_)});
  }

  [[nodiscard]] std::function<Replacement(const PassInput&, double)> contour_of(
      ReplaceOptions::Scope scope) const {
    using Sheets = ReplaceOptions::Sheets;
    const Sheets sheets = options_.solid ? Sheets::Dropped : Sheets::Kept;
    return [=](const PassInput& input, double left) {
      return replace_broken_solids(input,
                                   {.scope = scope, .sheets = sheets, .max_deviation = left});
    };
  }

  /// Keeps a replacement if it is good, and notes what it is.
  Outcome try_replacement(Trial trial) {
    Replacement made;
    double before = 0.0;
    std::size_t n_before = 0;
    const PlannedPass pass{trial.name, DefectCode::SelfIntersection, [&](const PassInput& input) {
                             before = driver_.mesh().deviation();
                             n_before = input.tracked.soup.n_faces();
                             made = trial.propose(input, max_deviation_ - before);
                             return made.result;
                           }};
    if (!try_pass(pass, std::move(trial.plan), std::move(trial.from_input))) {
      needs_larger_grid_ = made.needs_larger_grid;
      if (!made.result.refused.empty()) reason_ = made.result.refused.front().reason;
      return made.result.edits.empty() ? Outcome::NotProposed : Outcome::NotGood;
    }
    driver_.mesh().raise_deviation(before + made.deviation);
    const auto n_new = made.result.edits.added_faces.size();
    notes_.push_back("what was still broken was replaced by a new surface of " + grouped(n_new) +
                     " faces, " + readable(made.deviation) +
                     " from the old one at most where it was sampled (" + grouped(n_before) +
                     " -> " + grouped(driver_.mesh().tracked().soup.n_faces()) + " faces)");
    return Outcome::Kept;
  }

  void note_failure() { notes_.push_back("not good, and not replaced: " + reason_of_failure()); }

  [[nodiscard]] std::string reason_of_failure() const {
    const PreparedMesh& mesh = driver_.mesh().prepared();
    if (n_pairs_of_thin_solid_ != 0 && !whole_mesh_as_solid(mesh).any_bounds_solid) {
      return "it is a sheet, and as a thin solid it would still intersect itself, in " +
             grouped(n_pairs_of_thin_solid_) + " pairs of faces";
    }
    return reason_.empty() ? "no replacement was found that is good" : reason_;
  }

  RepairDriver& driver_;
  const RepairOptions& options_;
  const Tolerances& tolerances_;
  double max_deviation_;
  bool is_union_too_far_ = false;
  /// What the last union has lost.
  LostBoundary lost_;
  UnionMemory union_memory_;
  /// See UnionChoice.
  double offset_share_ = 0.0;
  bool needs_larger_grid_ = false;
  /// The numbers of intersecting pairs that the last trial of a pass left, and the last thin solid.
  std::size_t n_pairs_of_trial_ = 0;
  std::size_t n_pairs_of_thin_solid_ = 0;
  std::string reason_;
  std::vector<std::string> notes_;
};

}  // namespace

std::vector<std::string> guarantee_goodness(RepairDriver& driver, const RepairOptions& options) {
  return Guarantee(driver, options).run();
}

}  // namespace meshalyzer
