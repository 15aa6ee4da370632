#include "meshalyzer/repair/driver/internal/plan.h"

#include "meshalyzer/repair/driver/internal/remembered_pass.h"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <span>
#include <utility>

namespace meshalyzer {
namespace {

/// Appends passes whose code is to be fixed.
class Planner {
 public:
  explicit Planner(const DefectCodes& fixes) : fixes_(fixes) {}

  void add(PlannedPass pass) {
    if (fixes_.contains(pass.code)) add_always(std::move(pass));
  }
  /// A pass that repairs several codes.
  void add_for(std::initializer_list<DefectCode> codes, PlannedPass pass) {
    const bool is_wanted = std::any_of(codes.begin(), codes.end(),
                                       [this](DefectCode code) { return fixes_.contains(code); });
    if (is_wanted) add_always(std::move(pass));
  }
  void add_always(PlannedPass pass) { passes_.push_back(std::move(pass)); }
  [[nodiscard]] std::vector<PlannedPass> take() { return std::move(passes_); }

 private:
  DefectCodes fixes_;
  std::vector<PlannedPass> passes_;
};

/// Returns the pass that joins borders within a length: over growing lengths, so that near borders
/// come first and a larger length closes no less than a smaller one.
PlannedPass weld(double within) {
  return {.name = "weld borders",
          .code = DefectCode::Slit,
          .run = [within](const PassInput& input) { return weld_borders(input, within); },
          .may_create = {DefectCode::Flipped},
          .lengths =
              [within](const PassInput& input, std::span<const Index> changed) {
                return next_weld_length(input, within, changed);
              }};
}

/// Plans the operations that the user asks for by name, independently of the codes to be fixed.
void plan_operations(const RepairOptions& options, Planner& plan) {
  using enum DefectCode;
  if (options.turn == Turn::Everything) {
    plan.add_always({"flip", Inward, flip_all, {Inward}, Repeat::Once});
  }
  if (options.weld_within) plan.add_always(weld(*options.weld_within));
}

CutOptions cut_options(const RepairOptions& options, Sheets sheets) {
  CutOptions cut{.sheets = sheets, .is_for_guarantee = options.guarantee};
  const bool fills = options.borders == Borders::Holes && options.fixes.contains(DefectCode::Hole);
  if (!fills) return cut;
  cut.fill = options.fill;
  // A patch over a sheet encloses a region that the sheet does not mean as a solid.
  if (options.solid) cut.fill->sheets = FillSheets::No;
  return cut;
}

/// Returns the pass that splits edges. Where faces may stay in contact, it doubles no walls: what
/// coincides all over would be cut.
///
/// @param may_create  What splitting creates besides copies of walls.
PlannedPass split(const RepairOptions& options, DefectCodes may_create) {
  using enum DefectCode;
  // A copy of a face is as flat as that, and folded over as far.
  for (const DefectCode code : {FlatFacet, DegenerateFacet, Foldover}) may_create.insert(code);
  const SharedWalls shared =
      options.contact == Contact::Part ? SharedWalls::Doubled : SharedWalls::Left;
  return {"split edges", NonManifold,
          [shared](const PassInput& input) { return split_edges(input, shared); }, may_create};
}

PlannedPass drop(Fragments which) {
  return {"drop fragments", DefectCode::Hole,
          [which](const PassInput& input) { return drop_fragments(input, which); }};
}

void plan_fixes_before_cutting(const RepairOptions& options, const Tolerances& tolerances,
                               Planner& plan) {
  using enum DefectCode;
  // Cutting a mesh apart leaves contacts, and a fin cut off leaves a border.
  const DefectCodes cuts{Hole, SelfIntersection, Flipped};
  // Retracting a cap at a border, or at an edge that is otherwise defective, makes two such edges
  // of one.
  const DefectCodes bends{Hole, NonManifold, Flipped};
  plan.add({"drop corrupt records", Corrupt, drop_corrupt, {Hole}});
  plan.add({"drop duplicates", DuplicateFacet, drop_duplicates, {Hole}});
  plan.add(weld(tolerances.slit));
  plan.add({"drop copies", SelfIntersection, drop_copies});
  plan.add_for({DegenerateFacet, FlatFacet}, {"mend facets", DegenerateFacet, mend_facets, bends});
  if (options.solid) plan.add({"drop dividing walls", NonManifold, drop_dividing_walls});
  plan.add(split(options, cuts));
  plan.add({"split vertices", NonManifold, split_vertices, cuts});
  plan.add({"orient consistently", Flipped, orient_consistently});
  plan.add({"remove foldovers", Foldover, remove_foldovers, {Hole}});
  if (options.solid) plan.add(drop(Fragments::Small));
  if (options.borders == Borders::Holes) {
    plan.add({"fill holes", Hole, hole_filling(options.fill), {FlatFacet}});
  }
  plan.add({"orient outward", Inward, orient_outward});
  plan.add(drop(Fragments::Debris));
}

void plan_fixes_from_cutting(const RepairOptions& options, Sheets sheets, Planner& plan) {
  using enum DefectCode;
  if (options.contact == Contact::Part) {
    plan.add({"part contacts", NonManifold, part_contacts});
  }
  const PassFunction cut =
      remembered_pass([cut = cut_options(options, sheets)](const PassInput& input) {
        return cut_intersections(input, cut);
      });
  plan.add({.name = "refill tangles",
            .code = SelfIntersection,
            .run = [cut](const PassInput& input) { return refill_tangles(input, cut); },
            .may_create = {FlatFacet},
            .takes_time_for_pairs = true});
  plan.add({.name = "cut intersections",
            .code = SelfIntersection,
            .run = cut,
            .may_create = {NonManifold, FlatFacet, DegenerateFacet, Foldover, Flipped, Hole},
            .repeat = Repeat::OncePerRound,
            .takes_time_for_pairs = true,
            .must_mend = true});
  if (options.contact == Contact::Part) plan.add({"cut off tips", NonManifold, cut_off_tips});
  plan.add(drop(options.solid ? Fragments::All : Fragments::Debris));
  plan.add({"renew normals", VertexNormal, renew_normals});
  plan.add({"drop orphans", OrphanVertex, drop_orphans});
  plan.add({"renumber", Numbering, renumber});
}

}  // namespace

std::vector<PlannedPass> plan_after_replacement(const RepairOptions& options) {
  using enum DefectCode;
  Planner plan(options.fixes);
  plan.add_always({"orient outward", Inward, orient_outward});
  plan.add({"drop orphans", OrphanVertex, drop_orphans});
  plan.add({"renumber", Numbering, renumber});
  return plan.take();
}

std::vector<PlannedPass> plan_before_cutting(const RepairOptions& options,
                                             const Tolerances& tolerances) {
  Planner plan(options.fixes);
  plan_operations(options, plan);
  plan_fixes_before_cutting(options, tolerances, plan);
  return plan.take();
}

std::vector<PlannedPass> plan_before_contour(const RepairOptions& options,
                                             const Tolerances& tolerances) {
  const DefectCodes left{DefectCode::DegenerateFacet, DefectCode::Foldover, DefectCode::Hole};
  std::vector<PlannedPass> plan = plan_before_cutting(options, tolerances);
  std::erase_if(plan, [&](const PlannedPass& pass) { return left.contains(pass.code); });
  return plan;
}

std::vector<PlannedPass> plan_with_sheets_cut(const RepairOptions& options,
                                              const Tolerances& tolerances) {
  Planner plan(options.fixes);
  plan_fixes_before_cutting(options, tolerances, plan);
  plan_fixes_from_cutting(options, Sheets::Cut, plan);
  return plan.take();
}

std::vector<PlannedPass> plan_passes(const RepairOptions& options, const Tolerances& tolerances) {
  Planner plan(options.fixes);
  plan_operations(options, plan);
  plan_fixes_before_cutting(options, tolerances, plan);
  plan_fixes_from_cutting(options, Sheets::Left, plan);
  return plan.take();
}

std::vector<PlannedPass> plan_for_remaining_facets(const RepairOptions& options) {
  using enum DefectCode;
  Planner plan(options.fixes);
  if (!options.fixes.contains(DegenerateFacet) && !options.fixes.contains(FlatFacet)) return {};
  plan.add_always({"mend facets", DegenerateFacet, mend_remaining_facets});
  plan.add({"remove foldovers", Foldover, remove_foldovers, {Hole}});
  plan.add_always({"widen facets", DegenerateFacet, [](const PassInput& input) {
                     return widen_facets(input, TurningOver::Forbidden);
                   }});
  return plan.take();
}

std::vector<PlannedPass> plan_for_thin_walls(const RepairOptions& options) {
  using enum DefectCode;
  Planner plan(options.fixes);
  plan.add_for({DegenerateFacet, FlatFacet},
               {"widen facets", DegenerateFacet, [](const PassInput& input) {
                  return widen_facets(input, TurningOver::Permitted);
                }});
  plan.add({"lift foldovers", Foldover, lift_foldovers});
  return plan.take();
}

std::vector<PlannedPass> plan_to_join_contacts(const RepairOptions& options) {
  using enum DefectCode;
  Planner plan(options.fixes);
  if (options.contact == Contact::Part) {
    plan.add({.name = "join contacts",
              .code = NonManifold,
              .run = join_contacts,
              .may_create = {NonManifold, FlatFacet, DegenerateFacet, Foldover},
              .takes_time_for_pairs = true,
              .must_mend = true});
  }
  return plan.take();
}

std::vector<PlannedPass> plan_with_contacts_joined(const RepairOptions& options,
                                                   const Tolerances& tolerances) {
  std::vector<PlannedPass> plan = plan_passes(options, tolerances);
  for (PlannedPass& pass : plan_to_join_contacts(options)) plan.push_back(std::move(pass));
  return plan;
}

}  // namespace meshalyzer
