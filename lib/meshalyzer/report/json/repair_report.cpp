#include "meshalyzer/report/json/repair_report.h"

#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/report/json/bytes.h"
#include "meshalyzer/report/json/format.h"
#include "meshalyzer/report/json/lost.h"
#include "meshalyzer/report/json/point.h"
#include "meshalyzer/report/json/writer.h"
#include "meshalyzer/report/key_ids.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::string_view kSchema = "meshfixer-report/1";

void begin_report(JsonWriter& json) {
  json.begin_object();
  json.member("schema", kSchema);
  json.member("version", MESHALYZER_VERSION);
}

void write_name(JsonWriter& json, const MeshName& mesh) {
  write_bytes(json, "path", mesh.path);
  write_format(json, mesh.path, mesh.format);
  json.member("vertices", mesh.n_vertices);
  json.member("faces", mesh.n_faces);
}

void write_tolerances(JsonWriter& json, const Tolerances& tolerances) {
  json.key("tolerances");
  json.begin_object(JsonLayout::Row);
  json.member("degeneracy", tolerances.degeneracy);
  json.member("slit", tolerances.slit);
  json.member("height", tolerances.height);
  json.member("max_foldover_angle", tolerances.max_foldover_angle);
  json.end_object();
}

void write_ids(JsonWriter& json, std::string_view key, std::span<const Index> records,
               const Ids& ids) {
  json.key(key);
  json.begin_array(JsonLayout::Row);
  for (const Index record : records) json.value(ids.of(record));
  json.end_array();
}

void write_pairs(JsonWriter& json, const Defect& defect, const MeshName& mesh) {
  if (defect.pairs.empty()) return;
  json.key("pairs");
  json.begin_array(JsonLayout::Row);
  for (const IntersectingPair& pair : defect.pairs) {
    json.begin_array(JsonLayout::Row);
    json.value(mesh.face_ids.of(pair.face_a));
    json.value(mesh.face_ids.of(pair.face_b));
    json.value(contact_name(pair.kind));
    json.end_array();
  }
  json.end_array();
}

void write_edges(JsonWriter& json, const Defect& defect, const MeshName& mesh) {
  json.key("edges");
  json.begin_array(JsonLayout::Row);
  for (const auto& edge : defect.edges) {
    json.begin_array(JsonLayout::Row);
    for (const Index v : edge) json.value(mesh.vertex_ids.of(v));
    json.end_array();
  }
  json.end_array();
}

void write_defect(JsonWriter& json, const Defect& defect, const MeshName& mesh) {
  json.begin_object(JsonLayout::Row);
  json.member("code", defect_name(defect.code));
  json.member("severity", severity_name(defect.severity));
  write_ids(json, "vertices", defect.vertices, mesh.vertex_ids);
  write_edges(json, defect, mesh);
  write_ids(json, "faces", defect.faces, mesh.face_ids);
  write_pairs(json, defect, mesh);
  json.key("positions");
  json.begin_array(JsonLayout::Row);
  for (const Vec3& p : defect.positions) write_point(json, p);
  json.end_array();
  json.member("value", defect.value);
  json.member("limit", defect.limit);
  if (!defect.detail.empty()) json.member("detail", defect.detail);
  json.member("fixable", defect.fixable);
  if (defect.fixable) json.member("fix", catalogue_entry(defect.code).passes);
  json.end_object();
}

/// Writes the members `counts`, `total`, `listed` and `defects`.
void write_defects(JsonWriter& json, const MeshName& mesh, const DefectReport& report) {
  json.key("counts");
  json.begin_object();
  for (const DefectCode code : all_defect_codes()) {
    json.member(defect_name(code), report.count(code));
  }
  json.end_object();
  json.member("total", report.total());
  json.member("listed", report.defects.size());
  json.key("defects");
  json.begin_array();
  for (const Defect& defect : report.defects) write_defect(json, defect, mesh);
  json.end_array();
}

void write_fixes(JsonWriter& json, const DefectCodes& fixes) {
  json.key("fixes");
  json.begin_array(JsonLayout::Row);
  for (const DefectCode code : all_defect_codes()) {
    if (fixes.contains(code)) json.value(defect_name(code));
  }
  json.end_array();
}

void write_key_ids(JsonWriter& json, std::string_view key, const std::vector<std::int64_t>& ids) {
  if (ids.empty()) return;
  json.key(key);
  json.array(ids);
}

/// Writes rows [new id, old id] of the faces that are not the unchanged input face of the same id;
/// old is null in a hole patch.
void write_tracking(JsonWriter& json, const RepairReport& report, std::size_t mesh,
                    const std::vector<std::uint8_t>& is_changed) {
  const TrackedMesh& tracked = report.result.meshes[mesh].tracked;
  json.key("tracking");
  json.begin_array();
  for (std::size_t f = 0; f < tracked.face_keys.size(); ++f) {
    const auto face = static_cast<Index>(f);
    const Index origin = tracked.origin_of_face(face);
    const std::int64_t id = report.meshes[mesh].face_id(face);
    const bool is_old =
        tracked.face_keys[f] < tracked.n_input_faces && !is_changed[tracked.face_keys[f]];
    if (is_old && report.input.face_ids.of(origin) == id) continue;
    json.begin_array(JsonLayout::Row);
    json.value(id);
    if (origin == kNoIndex) {
      json.null();
    } else {
      json.value(report.input.face_ids.of(origin));
    }
    json.end_array();
  }
  json.end_array();
}

/// Tells for each face of the input whether an operation has changed it.
std::vector<std::uint8_t> changed_faces(const RepairReport& report) {
  std::vector<std::uint8_t> changed(report.input.n_faces, 0);
  for (const LoggedOperation& operation : report.result.log.operations) {
    for (const Index key : operation.changed_faces) {
      if (key < changed.size()) changed[key] = 1;
    }
  }
  return changed;
}

void write_step(JsonWriter& json, const LogStep& step) {
  json.begin_object(JsonLayout::Row);
  json.member("pass", step.pass);
  json.member("code", defect_name(step.code));
  json.member("operations", step.operations);
  json.member("undone", step.undone);
  json.member("faces_removed", step.faces_removed);
  json.member("faces_added", step.faces_added);
  json.member("faces_changed", step.faces_changed);
  json.member("vertices_removed", step.vertices_removed);
  json.member("vertices_added", step.vertices_added);
  json.member("vertices_moved", step.vertices_moved);
  json.member("distance", step.distance);
  json.end_object();
}

void write_operation(JsonWriter& json, const LoggedOperation& operation, const KeyIds& ids) {
  json.begin_object(JsonLayout::Row);
  json.member("step", operation.step);
  write_key_ids(json, "removed_faces", ids.faces(operation.removed_faces));
  write_key_ids(json, "added_faces", ids.faces(operation.added_faces));
  write_key_ids(json, "changed_faces", ids.faces(operation.changed_faces));
  write_key_ids(json, "removed_vertices", ids.vertices(operation.removed_vertices));
  write_key_ids(json, "added_vertices", ids.vertices(operation.added_vertices));
  write_key_ids(json, "moved_vertices", ids.vertices(operation.moved_vertices));
  json.member("distance", operation.distance);
  json.end_object();
}

void write_refusal(JsonWriter& json, const LoggedRefusal& refusal, const KeyIds& ids) {
  json.begin_object(JsonLayout::Row);
  json.member("pass", refusal.pass);
  json.member("code", defect_name(refusal.code));
  const auto vertex = ids.final_vertex(refusal.vertex);
  const auto face = ids.final_face(refusal.face);
  json.member("mesh",
              vertex || face ? std::optional((vertex ? vertex : face)->mesh) : std::nullopt);
  json.member("vertex", vertex ? std::optional(vertex->id) : std::nullopt);
  json.member("face", face ? std::optional(face->id) : std::nullopt);
  json.member("reason", refusal.reason);
  json.end_object();
}

void write_log(JsonWriter& json, const RepairReport& report) {
  const RepairLog& log = report.result.log;
  const KeyIds ids(report);
  json.key("log");
  json.begin_object();
  json.key("steps");
  json.begin_array();
  for (const LogStep& step : log.steps) write_step(json, step);
  json.end_array();
  json.key("operations");
  json.begin_array();
  for (const LoggedOperation& operation : log.operations) write_operation(json, operation, ids);
  json.end_array();
  json.key("refused");
  json.begin_array();
  for (const LoggedRefusal& refusal : log.refusals) write_refusal(json, refusal, ids);
  json.end_array();
  json.end_object();
}

/// Writes the counts that are higher than before, if there are any.
void write_rises(JsonWriter& json, const std::vector<CountRise>& rises) {
  if (rises.empty()) return;
  json.key("rises");
  json.begin_array();
  for (const CountRise& rise : rises) {
    json.begin_object(JsonLayout::Row);
    json.member("count", name_of(rise.kind));
    json.member("before", rise.before);
    json.member("after", rise.after);
    json.end_object();
  }
  json.end_array();
}

void write_meshes(JsonWriter& json, const RepairReport& report) {
  const std::vector<std::uint8_t> is_changed = changed_faces(report);
  json.key("meshes");
  json.begin_array();
  for (std::size_t i = 0; i < report.meshes.size(); ++i) {
    const FinalMesh& mesh = report.meshes[i];
    json.begin_object();
    write_name(json, mesh.name);
    json.member("written", !mesh.name.path.empty());
    write_defects(json, mesh.name, mesh.remaining);
    write_tracking(json, report, i, is_changed);
    json.end_object();
  }
  json.end_array();
}

/// Writes the outcome for each patch of intersecting faces, if it is known.
void write_patches(JsonWriter& json, const PatchReport& report) {
  if (report.patches.empty()) return;
  json.key("patches");
  json.begin_array();
  for (const PatchOutcome& patch : report.patches) {
    const std::vector<Index>& faces = report.defects[patch.defect].faces;
    json.begin_object(JsonLayout::Row);
    json.member("face", report.mesh.face_ids.of(faces.front()));
    json.member("faces", faces.size());
    json.member("mended", patch.is_mended);
    json.key("passes");
    json.array(patch.passes);
    json.member("distance", patch.distance);
    if (!patch.is_mended) json.member("reason", patch.reason);
    json.end_object();
  }
  json.end_array();
}

/// Writes the member `input`.
void write_input(JsonWriter& json, const MeshName& mesh, const DefectReport& found) {
  json.key("input");
  json.begin_object();
  write_name(json, mesh);
  write_tolerances(json, found.tolerances);
  json.key("warnings");
  json.array(found.warnings, JsonLayout::Lines);
  write_defects(json, mesh, found);
  json.end_object();
}

void write_remaining(JsonWriter& json, std::size_t n, bool may_have_more) {
  json.member("remaining", n);
  if (may_have_more) json.member("remaining_at_least", true);
}

}  // namespace

std::string json_report(const FoundDefects& found) {
  JsonWriter json;
  begin_report(json);
  write_input(json, found.mesh, found.defects);
  write_fixes(json, found.requested);
  write_remaining(json, found.defects.count(found.requested),
                  found.defects.may_have_more(found.requested));
  write_patches(json, {found.mesh, found.defects.defects, found.patches});
  json.end_object();
  return json.take();
}

std::string json_report(const RepairReport& report) {
  JsonWriter json;
  begin_report(json);
  write_input(json, report.input, report.result.before);
  write_fixes(json, report.fixes);
  json.member("max_deviation", report.result.max_deviation);
  json.member("deviation", report.result.deviation);
  write_remaining(json, n_remaining(report), may_have_more(report));
  write_rises(json, report.result.rises);
  write_patches(json, {report.input, report.result.before.defects, report.result.patches});
  json.key("notes");
  json.array(report.notes, JsonLayout::Lines);
  write_lost(json, report.lost);
  write_meshes(json, report);
  write_log(json, report);
  json.end_object();
  return json.take();
}

}  // namespace meshalyzer
