#include "meshalyzer/analysis/internal/measures.h"

#include "meshalyzer/analysis/internal/by_component.h"
#include "meshalyzer/analysis/internal/edge_lists.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sum.h"
#include "meshalyzer/geometry/coincidence.h"
#include "meshalyzer/geometry/edge_measures.h"
#include "meshalyzer/geometry/face_measures.h"
#include "meshalyzer/mesh/complex_edges.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace meshalyzer {
namespace {

/// Records measures in the statistics of the mesh, and in those of its components if these are
/// wanted.
class Measurer {
 public:
  Measurer(const CutMesh& cut, const Components& components, const AnalysisOptions& options,
           Analysis& analysis)
      : cut_(cut),
        components_(components),
        options_(options),
        analysis_(analysis),
        edge_lengths_(mesh_edge_lengths(cut.mesh)),
        sums_{std::vector<double>(components.count), std::vector<Index>(components.count)} {
    if (components.count >= 2 && components.count <= Analysis::kMaxComponentStatistics) {
      analysis.component_statistics.resize(components.count);
    }
  }

  /// @return The faces of zero area.
  std::vector<FaceHandle> measure_all_faces() {
    FaceMeasures faces = measure_faces(cut_.mesh, edge_lengths_);
    sum_areas(faces.area);
    for (const FaceHandle f : faces.zero_area) {
      analysis_.offenders.zero_area_faces.push_back(cut_.side.face(f));
      ++sums_.zero_area_faces[components_.of(f)];
    }
    analysis_.characteristics.zero_area_faces = faces.zero_area.size();
    if (options_.aspect_above) {
      analysis_.offenders.large_aspect_ratios =
          faces_above(faces.aspect_ratio, *options_.aspect_above);
    }
    const auto component = [&](std::size_t i) { return components_.of_face[i]; };
    record(
        [](auto& of) -> auto& { return of.face_area; }, std::move(faces.area), component);
    record(
        [](auto& of) -> auto& { return of.aspect_ratio; }, std::move(faces.aspect_ratio),
        component);
    record(
        [](auto& of) -> auto& { return of.corner_angle; }, std::move(faces.corner_angle),
        component);
    // Statistics exclude values that overflowed; the area must include them.
    analysis_.characteristics.area = analysis_.characteristics.face_area.infinite == 0
                                         ? analysis_.characteristics.face_area.total
                                         : std::numeric_limits<double>::infinity();
    return std::move(faces.zero_area);
  }

  void measure_lengths() {
    const std::vector<HalfedgeHandle> edges = complex_edges(cut_);
    std::vector<double> lengths = lengths_of(edges, edge_lengths_);
    if (options_.shorter_than) {
      analysis_.offenders.short_edges = list_edges_if(
          cut_, edges, lengths, [limit = *options_.shorter_than](double x) { return x < limit; });
    }
    if (options_.longer_than) {
      analysis_.offenders.long_edges = list_edges_if(
          cut_, edges, lengths, [limit = *options_.longer_than](double x) { return x > limit; });
    }
    list_indistinguishable(edges);
    record(
        [](auto& of) -> auto& { return of.edge_length; }, std::move(lengths),
        [&](std::size_t i) { return components_.of(cut_.mesh, edges[i]); });
  }

  void measure_angles(std::span<const FaceHandle> zero_area) {
    EdgeAngles angles = measure_edge_angles(cut_.mesh, zero_area);
    if (options_.angle_below_degrees) {
      analysis_.offenders.small_angles =
          list_edges_if(cut_, angles.edges, angles.degrees,
                        [limit = *options_.angle_below_degrees](double x) { return x < limit; });
    }
    if (options_.angle_above_degrees) {
      analysis_.offenders.large_angles =
          list_edges_if(cut_, angles.edges, angles.degrees,
                        [limit = *options_.angle_above_degrees](double x) { return x > limit; });
    }
    record(
        [](auto& of) -> auto& { return of.edge_angle; }, std::move(angles.degrees),
        [&](std::size_t i) { return components_.of(cut_.mesh, angles.edges[i]); });
  }

  void measure_valences() {
    const std::vector<Index> valences = vertex_valences(cut_);
    std::vector<Index> vertices;
    std::vector<double> values;
    for (std::size_t v = 0; v < valences.size(); ++v) {
      if (valences[v] != 0) {
        vertices.push_back(static_cast<Index>(v));
        values.push_back(valences[v]);
      }
    }
    const auto component = [&](std::size_t i) {
      const VertexHandle v(static_cast<int>(vertices[i]));
      return components_.of(cut_.mesh, cut_.mesh.halfedge_handle(v));
    };
    record(
        [](auto& of) -> auto& { return of.vertex_valence; }, std::move(values), component);
  }

  [[nodiscard]] ComponentMeasures take_sums() { return std::move(sums_); }

 private:
  void sum_areas(const std::vector<double>& areas) {
    std::vector<CompensatedSum> sums(components_.count);
    for (std::size_t i = 0; i < areas.size(); ++i) {
      sums[components_.of_face[i]].add(areas[i]);
    }
    for (std::size_t c = 0; c < sums.size(); ++c) {
      sums_.area[c] = sums[c].value();
    }
  }

  [[nodiscard]] FaceList faces_above(const std::vector<double>& values, double limit) const {
    FaceList list;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] > limit) {
        list.faces.push_back(cut_.side.faces[i]);
        list.values.push_back(values[i]);
      }
    }
    return list;
  }

  void list_indistinguishable(const std::vector<HalfedgeHandle>& edges) {
    const TriMesh& mesh = cut_.mesh;
    const Coincidence coincidence =
        options_.exact_coincidence ? Coincidence::Exact : Coincidence::Tolerant;
    Offenders& offenders = analysis_.offenders;
    offenders.indistinguishable_vertices = indistinguishable_ids(coincidence);
    std::vector<HalfedgeHandle> collapsed;
    if (!offenders.indistinguishable_vertices.empty()) {
      std::copy_if(edges.begin(), edges.end(), std::back_inserter(collapsed),
                   [&](HalfedgeHandle h) {
                     return is_indistinguishable(mesh.point(mesh.from_vertex_handle(h)),
                                                 mesh.point(mesh.to_vertex_handle(h)), coincidence);
                   });
    }
    offenders.indistinguishable_edges = list_edges(cut_, collapsed);
    analysis_.characteristics.indistinguishable_vertices =
        offenders.indistinguishable_vertices.size();
    analysis_.characteristics.indistinguishable_edges = collapsed.size();
  }

  /// Returns the indistinguishable vertices. Records that repeat an id are excluded: they are no
  /// vertices of their own.
  [[nodiscard]] std::vector<Index> indistinguishable_ids(Coincidence coincidence) const {
    const std::span<const Vec3> records(cut_.mesh.points(), cut_.side.n_file_vertices);
    const std::vector<Index>& repeated = analysis_.offenders.duplicate_vertex_records;
    if (repeated.empty()) {
      return find_indistinguishable_vertices(records, coincidence);
    }
    std::vector<Index> kept;
    std::vector<Vec3> positions;
    for (Index v = 0; v < records.size(); ++v) {
      if (!std::binary_search(repeated.begin(), repeated.end(), v)) {
        kept.push_back(v);
        positions.push_back(records[v]);
      }
    }
    std::vector<Index> found = find_indistinguishable_vertices(positions, coincidence);
    std::transform(found.begin(), found.end(), found.begin(), [&](Index i) { return kept[i]; });
    return found;
  }

  /// Summarises the values of a quantity, for the mesh and for each component, and keeps the values
  /// if that is requested.
  ///
  /// @param pick       Selects the quantity in any ElementMeasures.
  /// @param values     One value for each element.
  /// @param component  The component of element i.
  template <typename Pick>
  void record(Pick pick, std::vector<double> values,
              const std::function<Index(std::size_t)>& component) {
    if (!analysis_.component_statistics.empty()) {
      const std::vector<Summary> summaries =
          summarize_by_component(components_.count, values, component);
      for (std::size_t c = 0; c < summaries.size(); ++c) {
        pick(analysis_.component_statistics[c]) = summaries[c];
      }
    }
    pick(analysis_.characteristics) = summarize(values);
    if (options_.keep_values) {
      pick(analysis_.values) = std::move(values);
    }
  }

  const CutMesh& cut_;
  const Components& components_;
  const AnalysisOptions& options_;
  Analysis& analysis_;
  /// The lengths of all edges of the cut mesh.
  std::vector<double> edge_lengths_;
  ComponentMeasures sums_;
};

}  // namespace

ComponentMeasures measure(const CutMesh& cut, const Components& components,
                          const AnalysisOptions& options, Analysis& analysis) {
  Measurer measurer(cut, components, options, analysis);
  parallel_invoke(cut.mesh.n_faces(),
                  {[&] { measurer.measure_angles(measurer.measure_all_faces()); },
                   [&] {
                     measurer.measure_lengths();
                     measurer.measure_valences();
                   }});
  return measurer.take_sums();
}

}  // namespace meshalyzer
