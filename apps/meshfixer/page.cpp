#include "page.h"

#include "meshalyzer/io/file.h"
#include "meshalyzer/picture/deviation_field.h"
#include "meshalyzer/report/html/defects_page.h"
#include "meshalyzer/report/html/repair_changes.h"
#include "meshalyzer/report/html/repair_page.h"
#include "meshalyzer/report/text/patch_text.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace meshalyzer::fixer {
namespace {

void append_ids(const Ids& ids, std::size_t count, Ids& all) {
  for (std::size_t i = 0; i < count; ++i) {
    all.named.push_back(static_cast<std::int32_t>(ids.of(static_cast<Index>(i))));
  }
}

/// Maps the records of one of several meshes to those of the joined mesh.
class Shift {
 public:
  Shift(std::size_t n_vertices_before, std::size_t n_faces_before)
      : vertices_(static_cast<Index>(n_vertices_before)),
        faces_(static_cast<Index>(n_faces_before)) {}

  [[nodiscard]] Triangle operator()(Triangle triangle) const {
    for (Index& corner : triangle) corner += corner == kNoIndex ? 0 : vertices_;
    return triangle;
  }
  [[nodiscard]] Defect operator()(Defect defect) const {
    for (Index& vertex : defect.vertices) vertex += vertices_;
    for (std::array<Index, 2>& edge : defect.edges) {
      edge = {edge[0] + vertices_, edge[1] + vertices_};
    }
    for (Index& face : defect.faces) face += faces_;
    for (IntersectingPair& pair : defect.pairs) {
      pair.face_a += faces_;
      pair.face_b += faces_;
    }
    return defect;
  }

 private:
  Index vertices_;
  Index faces_;
};

/// Appends the defects of a code, by the records of the joined mesh.
void append_shifted(const DefectList& defects, DefectCode code, const Shift& shift,
                    DefectList& all) {
  for (std::size_t i = 0; i < defects.size(); ++i) {
    if (defects.code_of(i) == code) all.push_back(shift(defects[i]));
  }
}

/// Joins several meshes to one that is drawn.
Soup join(const std::vector<FinalSoup>& finals) {
  Soup all;
  for (const FinalSoup& mesh : finals) {
    const Soup& soup = *mesh.soup;
    const Shift shift(all.n_vertices(), all.n_faces());
    all.positions.insert(all.positions.end(), soup.positions.begin(), soup.positions.end());
    std::transform(soup.triangles.begin(), soup.triangles.end(), std::back_inserter(all.triangles),
                   shift);
  }
  return all;
}

/// The defects of several meshes that are drawn as one.
struct JoinedReport {
  DefectReport defects;
  MeshName name;
};

JoinedReport join(const std::vector<FinalMesh>& meshes) {
  JoinedReport all;
  if (meshes.empty()) return all;
  const MeshName& first = meshes.front().name;
  all.name.path = first.path;
  all.name.format = first.format;
  all.name.vertex_ids.first = first.vertex_ids.first;
  all.name.face_ids.first = first.face_ids.first;
  all.defects.tolerances = meshes.front().remaining.tolerances;
  std::vector<Shift> shifts;
  for (const auto& [name, report, vertex_records, face_records] : meshes) {
    shifts.emplace_back(all.name.n_vertices, all.name.n_faces);
    append_ids(name.vertex_ids, name.n_vertices, all.name.vertex_ids);
    append_ids(name.face_ids, name.n_faces, all.name.face_ids);
    all.name.n_vertices += name.n_vertices;
    all.name.n_faces += name.n_faces;
    for (std::size_t code = 0; code < kDefectCodes; ++code) {
      all.defects.counts[code] += report.counts[code];
    }
  }
  for (const DefectCode code : all_defect_codes()) {
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      append_shifted(meshes[i].remaining.defects, code, shifts[i], all.defects.defects);
    }
  }
  return all;
}

/// Returns all results as one mesh.
std::shared_ptr<const PreparedMesh> prepare(const std::vector<FinalSoup>& finals) {
  if (finals.size() != 1) {
    return std::make_shared<PreparedMesh>(std::make_shared<const Soup>(join(finals)));
  }
  const FinalSoup& mesh = finals.front();
  return mesh.prepared ? mesh.prepared : std::make_shared<PreparedMesh>(mesh.soup);
}

}  // namespace

Scene scene_of(const PreparedMesh& mesh, const DefectReport& defects) {
  return make_scene({.mesh = mesh, .defects = &defects}, computed_field_names());
}

void write_page(const std::string& file, const FoundPage& found) {
  std::vector<PagePatch> patches;
  for (const PatchOutcome& patch : found.patches) {
    const Defect defect = found.report.defects[patch.defect];
    patches.push_back({patch.defect, patch_text(patch, defect.faces.size())});
  }
  replace_file(file,
               html_report({found.name, found.report, found.scene, {}, patches}, found.requested));
}

void write_page(const std::string& file, const RepairReport& report, DrawnInput before,
                const std::vector<FinalSoup>& finals) {
  const JoinedReport all = join(report.meshes);
  const std::shared_ptr<const PreparedMesh> mesh = prepare(finals);
  Scene after = scene_of(*mesh, all.defects);
  add_field(before.scene, deviation_field(before.mesh->soup(), *mesh));
  add_field(after, deviation_field(mesh->soup(), *before.mesh));
  const RepairChanges changes = find_changes(report, before.mesh->soup(), mesh->soup());
  highlight_changes(before.scene, before.mesh->soup(), changes.before.places);
  highlight_changes(after, mesh->soup(), changes.after.places);
  const PageMesh shown_before{report.input, report.result.before, before.scene,
                              changes.before.changes};
  const PageMesh shown_after{all.name, all.defects, after, changes.after.changes};
  replace_file(file, html_report(RepairPage{report, shown_before, shown_after}));
}

}  // namespace meshalyzer::fixer
