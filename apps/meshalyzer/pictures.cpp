#include "pictures.h"

#include "field_export.h"
#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/picture/scene.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "separation_ply.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace meshalyzer {
namespace {

std::optional<double> smallest(const ObjectSeparation* separation) {
  std::optional<double> least;
  if (separation != nullptr) {
    for (const double distance : separation->distances) {
      if (!std::isnan(distance) && (!least || distance < *least)) {
        least = distance;
      }
    }
  }
  return least;
}

/// Makes the folder of a file, where it is one of those that are made.
void prepare(const std::string& file, const PicturePaths& paths) {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  if (std::find(paths.folders.begin(), paths.folders.end(), folder) != paths.folders.end()) {
    make_folder(folder);
  }
}

/// What a page tells of offenders: the first ones. Whole lists of many meshes that wait would fill
/// the memory.
Offenders first_offenders(const Offenders& all) {
  Offenders first;
  first.vertex_numbering = all.vertex_numbering;
  first.face_numbering = all.face_numbering;
  if (!all.torn_lines.empty()) {
    first.torn_lines = {all.torn_lines.front()};
  }
  return first;
}

}  // namespace

Pictures::Pictures(PictureSubject subject) : subject_(std::move(subject)) {
  if (subject_.options.html) {
    rows_.resize(subject_.files.size());
  }
}

bool Pictures::draws_meshes() const {
  return subject_.options.html || subject_.options.field_export;
}

void Pictures::on_mesh(Index number, const Analysis& mesh) {
  if (!draws_meshes()) {
    return;
  }
  Waiting waiting{mesh, std::nullopt};
  // What a journal knows has no file with it, and its pairs are by other records.
  if (mesh.soup) {
    waiting.pairs = std::move(waiting.analysis.offenders.intersecting_pairs);
  }
  waiting.analysis.offenders = first_offenders(mesh.offenders);
  waiting.analysis.soup.reset();
  if (subject_.separation == PictureSubject::Separation::Follows) {
    waiting_.emplace(number, std::move(waiting));
  } else if (mesh.soup) {
    draw(number, waiting, *mesh.soup, nullptr);
  } else {
    draw(number, waiting, read_mesh(subject_.files[number]), nullptr);
  }
}

void Pictures::on_unreadable(Index number, const std::string& why) {
  if (!rows_.empty()) {
    rows_[number].name = subject_.names[number];
    rows_[number].trouble = why;
  }
}

void Pictures::on_findings(const ObjectFindings& findings) {
  const ObjectSeparation* separation = findings.separation ? &*findings.separation : nullptr;
  if (separation != nullptr && !subject_.paths.separations.empty()) {
    prepare(subject_.paths.separations[findings.owner], subject_.paths);
    write_separation_ply(
        subject_.paths.separations[findings.owner],
        {subject_.files[findings.owner], *separation, subject_.options.separation.search_radius});
  }
  const auto waiting = waiting_.extract(findings.owner);
  if (!waiting.empty()) {
    draw(findings.owner, waiting.mapped(), read_mesh(subject_.files[findings.owner]), separation);
  }
}

void Pictures::draw(Index number, const Waiting& mesh, const Soup& soup,
                    const ObjectSeparation* separation) {
  PreparedMesh built(soup);
  if (mesh.pairs) {
    built.know_intersecting_pairs(*mesh.pairs);
  }
  const DefectReport defects = find_defects(built);
  const FieldSource source{built, &defects, separation,
                           subject_.options.analysis.curvature.value_or(VertexArea::Mixed)};
  if (subject_.options.field_export) {
    prepare(subject_.paths.fields[number], subject_.paths);
    write_field(subject_.paths.fields[number], source, *subject_.options.field_export);
  }
  if (subject_.options.html) {
    write_page(number, mesh, source);
  }
}

void Pictures::write_page(Index number, const Waiting& mesh, const FieldSource& source) {
  const Scene scene = make_scene(source, all_field_names());
  const MeshName name = name_of(source.mesh.soup(), subject_.files[number]);
  const std::string& page = subject_.paths.pages[number];
  std::string index;
  if (subject_.paths.index) {
    index = "../" + std::filesystem::path(*subject_.paths.index).filename().string();
    rows_[number] = index_row(mesh.analysis, *source.defects, subject_.names[number],
                              subject_.paths.links[number]);
    rows_[number].separation = smallest(source.separation);
  }
  prepare(page, subject_.paths);
  replace_file(page, html_report(MeshPage{mesh.analysis, {name, *source.defects, scene}, index}));
}

void Pictures::finish(const SetAnalysis* set) {
  for (const auto& [number, mesh] : std::exchange(waiting_, {})) {
    draw(number, mesh, read_mesh(subject_.files[number]), nullptr);
  }
  if (subject_.paths.index) {
    replace_file(*subject_.paths.index, html_index(rows_, set));
  }
}

}  // namespace meshalyzer
