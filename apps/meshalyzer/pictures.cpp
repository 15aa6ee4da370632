#include "pictures.h"

#include "field_export.h"
#include "make_folder.h"
#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/picture/scene.h"
#include "meshalyzer/picture/separation_values.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/report/html/mesh_page.h"
#include "meshalyzer/set/separation.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The input of the picture of an object.
struct SeparationPicture {
  /// The mesh file.
  const std::string& path;
  const ObjectSeparation& separation;
  /// The distance with the last colour; by default the largest one.
  std::optional<double> largest;
};

/// Returns a scale that begins at 0, not at the smallest value, so that near objects look near.
ColourScale scale_from_zero(const std::vector<double>& values, std::optional<double> largest) {
  const ColourScale all = scale_for(values);
  if (all.min < 0.0) {
    const double farthest = std::max(-all.min, all.max);
    return {Palette::Diverging, -farthest, farthest};
  }
  return {Palette::Sequential, 0.0, largest.value_or(all.max)};
}

/// Writes a picture of a mesh: the mesh with the separation of each vertex as its quality and
/// colour.
///
/// Distances are shown with viridis from 0 on; if a vertex lies inside another mesh, with a
/// diverging map that is white at 0. Vertices without a distance are grey and have quality NaN.
///
/// @param file  The file, which is replaced if it exists; its folder must exist.
/// @throws IoError if a file cannot be read or written.
void write_separation_ply(const std::string& file, const SeparationPicture& picture) {
  const Soup soup = read_mesh(picture.path);
  const Field field{FieldName::Separation, FieldPlace::Vertices, FieldKind::Magnitude,
                    separation_values(soup, picture.separation)};
  const FieldColours colours{field.name, scale_from_zero(field.values, picture.largest)};
  write_field(file, {soup, field, colours});
}

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

/// Makes the folder of a file if it is one of the folders of the pictures.
void prepare(const std::string& file, const PicturePaths& paths) {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  if (std::find(paths.folders.begin(), paths.folders.end(), folder) != paths.folders.end()) {
    make_folder(folder);
  }
}

/// Returns the first offenders, which a page shows. Whole lists of many waiting meshes would fill
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

bool draws_pictures(const Options& options) {
  return options.html || options.field_export.file || options.separation_ply;
}

bool draws_at_once(const Run& run) {
  return (run.options.html || run.options.field_export.file) && !run.request.between.separation;
}

Pictures::Pictures(const Run& run) : run_(run), paths_(run.pictures) {
  if (run.options.html) {
    rows_.resize(run.inputs.files.size());
  }
}

bool Pictures::draws_meshes() const {
  return run_.options.html || run_.options.field_export.file;
}

void Pictures::on_mesh(Index number, const Analysis& mesh) {
  if (!draws_meshes()) {
    return;
  }
  if (run_.request.between.separation) {
    wait(number, mesh);
  } else if (mesh.mesh) {
    draw(number, mesh, *mesh.mesh, nullptr);
  } else {
    read_and_draw(number, {mesh, std::nullopt}, nullptr);
  }
}

void Pictures::wait(Index number, const Analysis& mesh) {
  Waiting waiting{mesh, std::nullopt};
  // An analysis from a journal has no file, and its pairs refer to other records; a list that is
  // cut is not enough for a page. In both cases the page searches again.
  const Characteristics& c = mesh.characteristics;
  const bool is_cut = mesh.offenders.intersecting_pairs.size() < c.intersecting_pairs;
  if (mesh.soup && (!is_cut || c.is_search_stopped)) {
    waiting.pairs = std::move(waiting.analysis.offenders.intersecting_pairs);
  }
  waiting.analysis.offenders = first_offenders(mesh.offenders);
  waiting.analysis.soup.reset();
  waiting_.emplace(number, std::move(waiting));
}

void Pictures::on_unreadable(Index number, const std::string& why) {
  if (!rows_.empty()) {
    rows_[number].name = run_.inputs.names[number];
    rows_[number].error = why;
  }
}

void Pictures::on_findings(const ObjectFindings& findings) {
  const ObjectSeparation* separation = findings.separation ? &*findings.separation : nullptr;
  if (separation != nullptr && !paths_.separations.empty()) {
    prepare(paths_.separations[findings.owner], paths_);
    write_separation_ply(
        paths_.separations[findings.owner],
        {run_.inputs.files[findings.owner], *separation, run_.options.separation.search_radius});
  }
  const auto waiting = waiting_.extract(findings.owner);
  if (!waiting.empty()) {
    read_and_draw(findings.owner, waiting.mapped(), separation);
  }
}

void Pictures::read_and_draw(Index number, const Waiting& waiting,
                             const ObjectSeparation* separation) {
  const Soup soup = read_mesh(run_.inputs.files[number]);
  PreparedMesh mesh(soup, pair_limits(run_.request.mesh, {}));
  if (waiting.pairs) {
    mesh.set_intersecting_pairs(*waiting.pairs);
  }
  draw(number, waiting.analysis, mesh, separation);
}

void Pictures::draw(Index number, const Analysis& analysis, const PreparedMesh& mesh,
                    const ObjectSeparation* separation) {
  const DefectReport defects = find_defects(mesh);
  const FieldSource source{mesh, &defects, separation,
                           run_.request.mesh.curvature.value_or(VertexArea::Mixed)};
  const FieldExport& wanted = run_.options.field_export;
  if (wanted.file && (wanted.field != FieldName::Separation || separation != nullptr)) {
    prepare(paths_.fields[number], paths_);
    write_field(paths_.fields[number], source, wanted);
  }
  if (run_.options.html) {
    write_page(number, analysis, source);
  }
}

void Pictures::write_page(Index number, const Analysis& analysis, const FieldSource& source) {
  const Scene scene = make_scene(source, computed_field_names());
  const MeshName name = name_of(source.mesh.soup(), run_.inputs.files[number]);
  const std::string& page = paths_.pages[number];
  std::string index;
  if (paths_.index) {
    index = "../" + std::filesystem::path(*paths_.index).filename().string();
    rows_[number] =
        index_row(analysis, *source.defects, run_.inputs.names[number], paths_.links[number]);
    rows_[number].separation = smallest(source.separation);
  }
  prepare(page, paths_);
  replace_file(page, html_report(MeshPage{analysis, {name, *source.defects, scene}, index}));
}

void Pictures::finish(const SetAnalysis* set) {
  for (const auto& [number, waiting] : std::exchange(waiting_, {})) {
    read_and_draw(number, waiting, nullptr);
  }
  if (paths_.index) {
    replace_file(*paths_.index, html_index(rows_, set));
  }
}

}  // namespace meshalyzer
