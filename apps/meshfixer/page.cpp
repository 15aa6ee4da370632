#include "page.h"

#include "meshalyzer/io/file.h"
#include "meshalyzer/picture/scene.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/report/html/page.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace meshalyzer::fixer {
namespace {

Scene scene_of(const PreparedMesh& mesh, const DefectReport& defects) {
  return make_scene({.mesh = mesh, .defects = &defects}, all_field_names());
}

void append_ids(const Ids& ids, std::size_t count, Ids& all) {
  for (std::size_t i = 0; i < count; ++i) {
    all.named.push_back(static_cast<std::int32_t>(ids.of(static_cast<Index>(i))));
  }
}

/// Records of one of several meshes as those of all in one.
class Shift {
 public:
  explicit Shift(const Soup& before)
      : vertices_(static_cast<Index>(before.n_vertices())),
        faces_(static_cast<Index>(before.n_faces())) {}

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

/// Several meshes as one, to be drawn together.
struct JoinedMesh {
  Soup soup;
  DefectReport report;
  MeshName name;
};

JoinedMesh join(const std::vector<FinalMesh>& meshes, const std::vector<Soup>& soups) {
  JoinedMesh all;
  all.name = meshes.front().name;
  all.name.vertex_ids.named.clear();
  all.name.face_ids.named.clear();
  all.report.tolerances = meshes.front().remaining.tolerances;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const Shift shift(all.soup);
    const Soup& soup = soups[i];
    all.soup.positions.insert(all.soup.positions.end(), soup.positions.begin(),
                              soup.positions.end());
    std::transform(soup.triangles.begin(), soup.triangles.end(),
                   std::back_inserter(all.soup.triangles), shift);
    append_ids(meshes[i].name.vertex_ids, soup.n_vertices(), all.name.vertex_ids);
    append_ids(meshes[i].name.face_ids, soup.n_faces(), all.name.face_ids);
    const DefectReport& report = meshes[i].remaining;
    std::transform(report.defects.begin(), report.defects.end(),
                   std::back_inserter(all.report.defects), shift);
    for (std::size_t code = 0; code < kDefectCodes; ++code) {
      all.report.counts[code] += report.counts[code];
    }
  }
  std::stable_sort(all.report.defects.begin(), all.report.defects.end(),
                   [](const Defect& a, const Defect& b) { return a.code < b.code; });
  all.soup.vertex_ids = all.name.vertex_ids;
  all.soup.face_ids = all.name.face_ids;
  all.name.n_vertices = all.soup.n_vertices();
  all.name.n_faces = all.soup.n_faces();
  return all;
}

}  // namespace

void write_page(const std::string& file, const FoundPage& found) {
  const Scene scene = scene_of(found.mesh, found.report);
  replace_file(file, html_report({found.name, found.report, scene}, found.asked));
}

void write_page(const std::string& file, const RepairReport& report, const Soup& input,
                const std::vector<Soup>& finals) {
  const Scene before = scene_of(PreparedMesh(input), report.result.before);
  const JoinedMesh all = report.meshes.empty() ? JoinedMesh{} : join(report.meshes, finals);
  const Scene after = scene_of(PreparedMesh(all.soup), all.report);
  replace_file(file, html_report(RepairPage{report,
                                            {report.input, report.result.before, before},
                                            {all.name, all.report, after}}));
}

}  // namespace meshalyzer::fixer
