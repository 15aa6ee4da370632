#include "meshalyzer/picture/scene.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/geometry/vertex_normals.h"
#include "meshalyzer/mesh/finite_positions.h"
#include "meshalyzer/picture/internal/drawn_surface.h"
#include "meshalyzer/picture/internal/edge_lengths.h"
#include "meshalyzer/picture/internal/highlighted_elements.h"
#include "meshalyzer/picture/internal/highlights.h"
#include "meshalyzer/picture/internal/neighbourhoods.h"
#include "meshalyzer/picture/internal/scene_lines.h"
#include "meshalyzer/picture/internal/vertex_clusters.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

const DefectReport& no_defects() {
  static const DefectReport none;
  return none;
}

/// Converts a value to single precision; finite values stay finite.
float to_float(double value) {
  constexpr double kMax = std::numeric_limits<float>::max();
  return static_cast<float>(std::isfinite(value) ? std::clamp(value, -kMax, kMax) : value);
}

std::vector<float> values_on(const Field& field, const DrawnSurface& surface) {
  const std::vector<Index>& records =
      field.place == FieldPlace::Vertices ? surface.vertices : surface.faces;
  std::vector<float> values(records.size());
  std::transform(records.begin(), records.end(), values.begin(),
                 [&](Index record) { return to_float(field.values[record]); });
  return values;
}

DrawnField draw_field(const Field& field, const DrawnSurface& detail, const DrawnSurface& context) {
  DrawnField drawn;
  drawn.name = field.name;
  drawn.place = field.place;
  drawn.kind = field.kind;
  drawn.detail = values_on(field, detail);
  drawn.context = values_on(field, context);
  drawn.scale = scale_of(field);
  std::tie(drawn.min, drawn.max) = finite_range(field.values).value_or(std::pair(0.0, 0.0));
  return drawn;
}

/// Selects the values of fields at the vertices and faces that are drawn.
std::vector<DrawnField> draw_fields(std::span<const Field> fields, const DrawnSurface& detail,
                                    const DrawnSurface& context) {
  std::vector<DrawnField> drawn;
  drawn.reserve(fields.size());
  for (const Field& field : fields) drawn.push_back(draw_field(field, detail, context));
  return drawn;
}

/// Makes a scene, part by part.
class SceneMaker {
 public:
  SceneMaker(const FieldSource& source, const SceneLimits& limits)
      : source_(source),
        limits_(limits),
        report_(source.defects != nullptr ? *source.defects : no_defects()),
        faces_(drawable_faces(soup())),
        frame_(box_of(soup(), faces_)),
        highlighted_(source.mesh, report_, highlight_limits()) {
    scene_.centre = frame_.centre();
    scene_.radius = frame_.radius();
    scene_.scale = frame_.scale();
    scene_.n_faces = faces_.size();
  }

  [[nodiscard]] Scene make(const std::vector<FieldName>& names) {
    draw_surfaces();
    scene_.fields = draw_fields(compute_fields(source_, names), scene_.detail, scene_.context);
    highlight_defects();
    DrawnLines drawn = draw_lines(source_.mesh, frame_, limits_.max_segments);
    scene_.lines = std::move(drawn.lines);
    note_surface();
    note_defects();
    std::move(drawn.notes.begin(), drawn.notes.end(), std::back_inserter(scene_.notes));
    return std::move(scene_);
  }

 private:
  [[nodiscard]] const Soup& soup() const { return source_.mesh.soup(); }
  [[nodiscard]] bool is_whole() const { return faces_.size() <= limits_.max_whole_faces; }

  /// Returns limits that leave half of the detail to the surroundings of the defects.
  [[nodiscard]] SceneLimits highlight_limits() const {
    SceneLimits limits = limits_;
    if (!is_whole()) {
      limits.max_elements_of_all =
          std::min(limits.max_elements_of_all, limits.max_detail_faces / 2);
    }
    return limits;
  }

  void draw_surfaces() {
    const std::vector<Vec3> normals = vertex_normals(source_.mesh.cut());
    if (is_whole()) {
      scene_.detail = draw_surface(soup(), frame_, triangles_of(soup(), faces_), normals);
      return;
    }
    TriangleList detail = triangles_of(
        soup(), faces_round(soup(), faces_, highlighted_.seeds(soup()), limits_.max_detail_faces));
    std::vector<Index> rest;
    std::set_difference(faces_.begin(), faces_.end(), detail.faces.begin(), detail.faces.end(),
                        std::back_inserter(rest));
    scene_.n_decimated = rest.size();
    const std::vector<std::uint8_t> pinned = used_vertices(soup(), detail);
    scene_.context = draw_surface(
        soup(), frame_,
        cluster_vertices(soup(), frame_, std::move(rest), {limits_.max_context_faces, pinned}),
        normals);
    scene_.detail = draw_surface(soup(), frame_, std::move(detail), normals);
  }

  void highlight_defects() {
    if (highlighted_.all().empty()) return;
    const EdgeLengths lengths(soup(), frame_, faces_);
    scene_.highlights =
        make_highlights({soup(), frame_, lengths, scene_.detail}, highlighted_.all());
  }

  void note_surface() {
    const std::size_t n_left_out = soup().n_faces() - faces_.size();
    if (n_left_out > 0) {
      scene_.notes.push_back(counted(n_left_out, "face is", "faces are") +
                             " not drawn: corners have no place.");
    }
    if (scene_.context.n_faces() == scene_.n_decimated) return;
    const std::string drawn =
        scene_.detail.n_faces() == 0
            ? ", drawn"
            : fmt::format("; the {} nearest to the defects are drawn as they are, the other {}",
                          grouped(scene_.detail.n_faces()), grouped(scene_.n_decimated));
    scene_.notes.push_back(
        fmt::format("The mesh has {}{} decimated to {}, coloured by the values of the file at the "
                    "vertices and faces that are left.",
                    counted(scene_.n_faces, "face", "faces"), drawn,
                    counted(scene_.context.n_faces(), "face", "faces")));
  }

  void note_defects() {
    std::array<std::size_t, kDefectCodes> n_highlighted{};
    for (const HighlightedElements& elements : highlighted_.all()) {
      ++n_highlighted[static_cast<std::size_t>(report_.defects.code_of(elements.number))];
    }
    for (const DefectCode code : all_defect_codes()) {
      const std::size_t n = n_highlighted[static_cast<std::size_t>(code)];
      if (n >= report_.count(code)) continue;
      scene_.notes.push_back(fmt::format("Of {} of code {} the first {} can be lit up.",
                                         counted(report_.count(code), "defect", "defects"),
                                         defect_name(code), grouped(n)));
    }
    note_cut_highlights();
  }

  void note_cut_highlights() {
    const auto n_cut = std::count_if(scene_.highlights.begin(), scene_.highlights.end(),
                                     [](const Highlight& highlight) { return highlight.is_cut; });
    if (n_cut == 0) return;
    scene_.notes.push_back(
        fmt::format("Of {} only a part is lit up.",
                    counted(static_cast<std::size_t>(n_cut), "defect", "defects")));
  }

  const FieldSource& source_;
  const SceneLimits& limits_;
  const DefectReport& report_;
  /// The faces that can be drawn.
  std::vector<Index> faces_;
  DrawingFrame frame_;
  HighlightedDefects highlighted_;
  Scene scene_;
};

}  // namespace

Scene make_scene(const FieldSource& source, const std::vector<FieldName>& names,
                 const SceneLimits& limits) {
  require_finite_positions(source.mesh.cut().mesh);
  return SceneMaker(source, limits).make(names);
}

void add_field(Scene& scene, const Field& field) {
  scene.fields.push_back(draw_field(field, scene.detail, scene.context));
}

void highlight_changes(Scene& scene, const Soup& soup, std::span<const ChangedPlace> changes,
                       const SceneLimits& limits) {
  if (changes.empty()) return;
  const std::vector<Index> faces = drawable_faces(soup);
  const DrawingFrame frame(box_of(soup, faces));
  const EdgeLengths lengths(soup, frame, faces);
  scene.changes =
      make_highlights({soup, frame, lengths, scene.detail}, elements_of_changes(changes, limits));
}

}  // namespace meshalyzer
