#include "meshalyzer/repair/fix_defects.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/repair/edits/apply_edits.h"
#include "meshalyzer/repair/records/keep_largest.h"
#include "meshalyzer/repair/records/separate.h"
#include "meshalyzer/repair/trial/fixed_vertices.h"
#include "meshalyzer/repair/trial/plan.h"
#include "meshalyzer/repair/trial/workshop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace meshalyzer {
namespace {

double length_of(const Deviation& deviation, const Box3& box) {
  if (!(deviation.value >= 0.0) || !std::isfinite(deviation.value)) {
    throw InvalidArgument("the maximum deviation must be finite and not negative");
  }
  if (deviation.unit == Deviation::Unit::Length) return deviation.value;
  if (box.isEmpty()) return 0.0;
  // The diagonal itself may be too large for a double.
  const Vec3 quarter = box.max() / 4 - box.min() / 4;
  return std::min(quarter.stableNorm() * (4 * deviation.value), std::numeric_limits<double>::max());
}

/// Numbers the records of a mesh anew: what taking it from others has left gaps in.
Draft renumbered(const Draft& draft, const Tolerances& tolerances) {
  const PreparedMesh mesh(draft.soup);
  const RepairLimits limits;
  return apply_edits(draft, renumber({draft, mesh, tolerances, limits}).edits);
}

std::vector<RepairedMesh> finished_meshes(Workshop& workshop, const RepairOptions& options,
                                          const Tolerances& tolerances) {
  const DefectOptions find{.codes = DefectCodes::all(),
                           .tolerances = as_options(tolerances),
                           .max_defects = options.max_defects};
  std::vector<Draft> drafts;
  if (options.fixes.contains(DefectCode::Disjoint)) {
    drafts = separate(workshop.draft());
  } else {
    drafts.push_back(workshop.draft());
  }
  std::vector<RepairedMesh> meshes;
  for (Draft& draft : drafts) {
    RepairedMesh& mesh = meshes.emplace_back();
    mesh.draft = options.fixes.contains(DefectCode::Numbering) ? renumbered(draft, tolerances)
                                                               : std::move(draft);
    mesh.remaining = find_defects(mesh.draft.soup, find);
  }
  return meshes;
}

/// Adds a refusal for each code that was to be fixed and remains, where no pass has said why.
void name_what_has_no_reason(const RepairOptions& options, RepairResult& result) {
  DefectCodes unsaid = options.fixes;
  // No pass treats these yet: their defects say so themselves.
  unsaid.erase(DefectCode::SelfIntersection);
  if (options.borders == Borders::Meant) unsaid.erase(DefectCode::Hole);
  for (const LoggedRefusal& refusal : result.log.refusals) unsaid.erase(refusal.code);
  for (const RepairedMesh& mesh : result.meshes) {
    for (const Defect& defect : mesh.remaining.defects) {
      if (!unsaid.contains(defect.code)) continue;
      unsaid.erase(defect.code);
      LoggedRefusal& refusal = result.log.refusals.emplace_back();
      refusal.pass = "every pass";
      refusal.code = defect.code;
      if (!defect.vertices.empty())
        refusal.vertex = mesh.draft.vertex_keys[defect.vertices.front()];
      if (!defect.faces.empty()) refusal.face = mesh.draft.face_keys[defect.faces.front()];
      refusal.reason = "no pass found a way within the maximum deviation";
    }
  }
}

}  // namespace

DefectCodes default_fixes() {
  DefectCodes codes = DefectCodes::all();
  codes.erase(DefectCode::Disjoint);
  codes.erase(DefectCode::Numbering);
  return codes;
}

RepairResult fix_defects(Soup soup, const RepairOptions& options) {
  if (!has_finite_positions(soup)) {
    throw InvalidArgument("a position is not finite: there is no mesh to repair");
  }
  const Box3 box = used_box(soup);
  const Tolerances tolerances = resolve_tolerances(options.tolerances, box);
  RepairLimits limits;
  limits.max_deviation = length_of(options.max_deviation, box);
  limits.groups = options.groups;

  RepairResult result;
  result.max_deviation = limits.max_deviation;
  Workshop workshop(std::move(soup), tolerances, std::move(limits),
                    [&](const Draft& draft, const CutMesh& cut) {
                      return find_fixed_vertices(draft, cut, options);
                    });
  result.before = find_defects(workshop.mesh(), {.codes = DefectCodes::all(),
                                                 .tolerances = options.tolerances,
                                                 .max_defects = options.max_defects});
  workshop.work_off(plan_passes(options, tolerances), options.on_phase);
  if (options.keep_largest != 0) {
    workshop.obey({"keep largest", DefectCode::Disjoint, [&](const PassInput& input) {
                     return keep_largest(input, options.keep_largest);
                   }});
  }
  result.meshes = finished_meshes(workshop, options, tolerances);
  result.deviation = workshop.deviation();
  result.log = workshop.take_log();
  name_what_has_no_reason(options, result);
  return result;
}

}  // namespace meshalyzer
