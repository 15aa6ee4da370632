#include "meshalyzer/repair/fix_defects.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/require.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/mesh/finite_positions.h"
#include "meshalyzer/mesh/require_records.h"
#include "meshalyzer/mesh/used_box.h"
#include "meshalyzer/repair/driver/internal/dropped_parts.h"
#include "meshalyzer/repair/driver/internal/final_check.h"
#include "meshalyzer/repair/driver/internal/patch_outcomes.h"
#include "meshalyzer/repair/driver/internal/plan.h"
#include "meshalyzer/repair/driver/internal/reason_left.h"
#include "meshalyzer/repair/driver/internal/repair_driver.h"
#include "meshalyzer/repair/edits/apply_edits.h"
#include "meshalyzer/repair/guarantee/internal/guarantee.h"
#include "meshalyzer/repair/records/internal/keep_largest.h"
#include "meshalyzer/repair/records/separate.h"
#include "meshalyzer/repair/rules/internal/fixed_vertices.h"
#include "meshalyzer/topology/border.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {
namespace {

/// Numbers the records of a mesh anew.
TrackedMesh renumbered(const TrackedMesh& tracked, const Tolerances& tolerances) {
  const PreparedMesh mesh(tracked.soup);
  const RepairLimits limits;
  return apply_edits(tracked, renumber({tracked.soup, tracked, mesh, tolerances, limits}).edits);
}

/// Tells whether all records have the numbers that they are to have.
bool is_numbered(const MeasuredMesh& mesh) {
  const RepairLimits limits;
  return renumber({mesh.input(), mesh.tracked(), mesh.prepared(), mesh.tolerances(), limits})
      .edits.empty();
}

/// @param before  The defects of the input.
std::vector<RepairedMesh> finished_meshes(const RepairDriver& driver, const RepairOptions& options,
                                          const DefectReport& before) {
  const MeasuredMesh& repaired = driver.mesh();
  const DefectOptions find{.codes = DefectCodes::all(),
                           .tolerances = as_options(repaired.tolerances()),
                           .max_defects = options.max_defects,
                           .pairs = {.max_found = repaired.max_pairs(), .wants_to_stop = {}}};
  const bool is_separated = options.fixes.contains(DefectCode::Disjoint);
  // Separation leaves gaps in the numbers.
  const bool is_renumbered =
      options.fixes.contains(DefectCode::Numbering) && (is_separated || !is_numbered(repaired));
  if (!is_separated && !is_renumbered) {
    return {
        {.tracked = repaired.tracked(),
         .remaining = driver.log().steps.empty() ? before : find_defects(repaired.prepared(), find),
         .prepared = options.keep_prepared ? repaired.shared_prepared() : nullptr}};
  }
  std::vector<TrackedMesh> tracked_meshes;
  if (is_separated) {
    tracked_meshes = separate(repaired.tracked());
  } else {
    tracked_meshes.push_back(repaired.tracked());
  }
  std::vector<RepairedMesh> meshes;
  for (TrackedMesh& tracked : tracked_meshes) {
    RepairedMesh& mesh = meshes.emplace_back();
    mesh.tracked = is_renumbered ? renumbered(tracked, repaired.tolerances()) : std::move(tracked);
    mesh.remaining = find_defects(mesh.tracked.soup, find);
  }
  return meshes;
}

/// Adds a refusal for each code that was to be fixed and remains without a reason from any pass.
void name_what_has_no_reason(const RepairOptions& options, const std::string& reason,
                             RepairResult& result) {
  DefectCodes unexplained = options.fixes;
  if (options.borders == Borders::Intended) unexplained.erase(DefectCode::Hole);
  if (options.contact == Contact::Keep) unexplained.erase(DefectCode::SelfIntersection);
  for (const LoggedRefusal& refusal : result.log.refusals) unexplained.erase(refusal.code);
  for (const RepairedMesh& mesh : result.meshes) {
    const DefectList& defects = mesh.remaining.defects;
    for (std::size_t i = 0; i < defects.size(); ++i) {
      if (!unexplained.contains(defects.code_of(i))) continue;
      const Defect defect = defects[i];
      unexplained.erase(defect.code);
      LoggedRefusal& refusal = result.log.refusals.emplace_back();
      refusal.pass = "every pass";
      refusal.code = defect.code;
      if (!defect.vertices.empty()) {
        refusal.vertex = mesh.tracked.vertex_keys[defect.vertices.front()];
      }
      if (!defect.faces.empty()) refusal.face = mesh.tracked.face_keys[defect.faces.front()];
      refusal.reason = reason;
    }
  }
}

/// So many intersecting pairs are few, whatever the number of faces.
constexpr std::size_t kPairsAlwaysCut = 1000;

/// Tells whether sheets may be left that intersect something. They are cut last, because that makes
/// borders: only what all other passes leave is worth that. Surfaces with more intersecting pairs
/// than faces are in such disorder that cutting them takes long and leaves hardly anything whole.
bool is_any_sheet_to_cut(const RepairDriver& driver, const RepairOptions& options) {
  const PreparedMesh& mesh = driver.mesh().prepared();
  return options.fixes.contains(DefectCode::SelfIntersection) && !options.solid &&
         !driver.is_stopped() && !mesh.intersecting_pairs().empty() &&
         mesh.intersecting_pairs().size() <= std::max(kPairsAlwaysCut, mesh.soup().n_faces()) &&
         !find_border_edges(mesh.cut()).empty();
}

/// Drops equal faces where too many pairs of faces intersect: a few thousand of them make millions.
/// This is not checked, so that faces that are closed by themselves keep one of each direction.
/// @return Whether all pairs are now known, so that the mesh can be repaired.
bool drop_equal_faces(RepairDriver& driver, const RepairOptions& options,
                      const DefectReport& before) {
  constexpr DefectCode kCode = DefectCode::DuplicateFacet;
  if (!has_too_many_pairs(driver) || !options.fixes.contains(kCode) || before.count(kCode) == 0) {
    return false;
  }
  return driver.run_trial({.changes = {{"drop duplicates", kCode, drop_surplus_duplicates}},
                           .plan = {},
                           .is_wanted = [](const RepairState& state) {
                             static_cast<void>(state.mesh().intersecting_pairs());
                             return !state.mesh().was_intersection_search_cut();
                           }});
}

/// Where more pairs of faces intersect, thin facets and foldovers are the least of what is wrong,
/// and running all passes again takes long.
constexpr std::size_t kMostPairsBesideFacets = 100;

bool is_ready_for_facets(const RepairDriver& driver) {
  return !driver.is_stopped() &&
         driver.mesh().prepared().intersecting_pairs().size() <= kMostPairsBesideFacets;
}

bool has_thin_facets(const RepairDriver& driver) {
  return !find_thin_facets(driver.mesh().prepared(), driver.mesh().tolerances()).empty();
}

bool has_foldovers(const RepairDriver& driver) {
  return !find_foldovers(driver.mesh().prepared(), driver.mesh().tolerances()).empty();
}

/// Runs a plan after others, of whose refusals some stay.
///
/// @return Whether it has changed the mesh.
bool run_after_others(RepairDriver& driver, const std::vector<PlannedPass>& plan,
                      const std::vector<LoggedRefusal>& refusals) {
  const std::size_t n_operations = driver.log().operations.size();
  driver.run_plan(plan);
  driver.add_refusals(refusals);
  return driver.log().operations.size() != n_operations;
}

/// Mends the flat and degenerate facets that all passes have left. What passes have refused to
/// repair besides stays refused.
///
/// @return Whether it has changed the mesh.
bool mend_facets_left(RepairDriver& driver, const RepairOptions& options) {
  const std::vector<PlannedPass> plan = plan_for_remaining_facets(options);
  if (plan.empty() || !is_ready_for_facets(driver) || !has_thin_facets(driver)) return false;
  std::vector<LoggedRefusal> others = driver.log().refusals;
  std::erase_if(others, [](const LoggedRefusal& refusal) {
    return DefectCodes{DefectCode::DegenerateFacet, DefectCode::FlatFacet, DefectCode::Foldover}
        .contains(refusal.code);
  });
  return run_after_others(driver, plan, others);
}

/// Makes thin walls as thick as the tolerance, where facets and foldovers are left.
///
/// @return Whether it has changed the mesh.
bool thicken_walls_left(RepairDriver& driver, const RepairOptions& options) {
  const std::vector<PlannedPass> plan = plan_for_thin_walls(options);
  if (plan.empty() || !is_ready_for_facets(driver) ||
      (!has_thin_facets(driver) && !has_foldovers(driver))) {
    return false;
  }
  const std::vector<LoggedRefusal> refusals = driver.log().refusals;
  return run_after_others(driver, plan, refusals);
}

void run_passes(RepairDriver& driver, const RepairOptions& options) {
  const Tolerances& tolerances = driver.mesh().tolerances();
  driver.run_plan(plan_passes(options, tolerances));
  if (is_any_sheet_to_cut(driver, options)) {
    driver.run_plan(plan_with_sheets_cut(options, tolerances), OnWorse::Leave);
  }
}

/// The maximum number of times that the facets left are mended and all passes run again, in case
/// they undo each other's work for ever.
constexpr int kMostRepeats = 10;

/// Runs all passes, and replaces what they leave if that is asked for.
void repair(RepairDriver& driver, const RepairOptions& options, RepairResult& result) {
  run_passes(driver, options);
  if (options.guarantee) result.notes = guarantee_goodness(driver, options);
  for (int i = 0; i < kMostRepeats &&
                  (mend_facets_left(driver, options) || thicken_walls_left(driver, options));
       ++i) {
    // A repair of the result would run them, too.
    run_passes(driver, options);
  }
  if (options.reports_patches) result.patches = find_patch_outcomes(driver, result.before);
  if (options.keep_largest != 0) {
    driver.apply_unchecked({"keep largest", DefectCode::Disjoint, [&](const PassInput& input) {
                              return keep_largest(input, options.keep_largest);
                            }});
  }
  result.deviation = driver.mesh().deviation();
  result.is_stopped = driver.is_stopped();
  result.rises = driver.rises();
}

/// Tolerances and the maximum deviation are checked where they are converted.
void require_valid(const RepairOptions& options) {
  require_length("the length within which borders are joined", options.weld_within);
  if (options.fill.at) require_point("the point of the hole to fill", *options.fill.at);
}

}  // namespace

RepairResult fix_defects(Soup soup, const RepairOptions& options) {
  require_records(soup);
  require_finite_positions(soup);
  require_valid(options);
  const Box3 box = used_box(soup);
  const Tolerances tolerances = resolve_tolerances(options.tolerances, box);
  RepairLimits limits;
  limits.max_deviation = length_of(options.max_deviation, box);
  limits.groups = options.groups;

  const DriverSettings settings{.pairs = pair_limits(options, soup.n_faces()),
                                .check = final_check_for(options, soup.format),
                                .on_progress = options.on_progress};

  RepairResult result;
  result.max_deviation = limits.max_deviation;
  RepairDriver driver(
      std::move(soup), tolerances, std::move(limits),
      [&](const TrackedMesh& tracked, const CutMesh& cut) {
        return find_fixed_vertices(tracked, cut, options);
      },
      settings);
  DefectOptions find;
  find.tolerances = options.tolerances;
  find.max_defects = options.max_defects;
  find.wants_to_stop = options.wants_to_stop;
  result.before = find_defects(driver.mesh().prepared(), find);
  if (options.on_input) options.on_input(driver.mesh().shared_prepared(), result.before);
  if (reason_against_repair(driver).empty() || drop_equal_faces(driver, options, result.before)) {
    repair(driver, options, result);
  } else {
    result.is_stopped = options.wants_to_stop();
    if (options.reports_patches) result.patches = find_patch_outcomes(driver, result.before);
  }
  result.meshes = finished_meshes(driver, options, result.before);
  result.log = driver.take_log();
  append_dropped_parts(driver.mesh().input(), driver.mesh().tracked(), result.log, result.notes);
  name_what_has_no_reason(options, reason_of_defects_left(driver), result);
  return result;
}

}  // namespace meshalyzer
