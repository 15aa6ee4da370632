#pragma once

#include "meshalyzer/analysis/curvature_statistics.h"
#include "meshalyzer/analysis/element_measures.h"
#include "meshalyzer/analysis/offenders.h"
#include "meshalyzer/base/statistics.h"
#include "meshalyzer/base/types.h"
#include "meshalyzer/mesh/soup.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// A value, or the reason why there is none.
template <typename T>
struct Measure {
  std::optional<T> value;
  /// The reason why there is no value, in words that follow "undefined: ".
  std::string reason;
};

/// The answer yes or no, or the reason why there is none.
using Answer = Measure<bool>;

/// The integrity of a file's records ("Integrity" in doc/definitions.md).
struct Integrity {
  std::size_t orphan_vertices = 0;
  /// Counts each id once, however many faces use it.
  std::size_t missing_vertices = 0;
  std::size_t degenerate_faces = 0;
  /// Counts the records beyond the first that has the same id.
  std::size_t duplicate_vertex_indices = 0;
  std::size_t duplicate_face_indices = 0;
  /// Counts the lines of a `.mesh` file that begin with a number, as the remains of a torn record
  /// do; they are no records (Soup::torn_lines).
  std::size_t torn_lines = 0;
  bool contiguous_vertices = true;
  bool contiguous_faces = true;
};

/// The five attributes of a mesh ("Attributes" in doc/definitions.md).
struct Attributes {
  Answer closed;
  Answer manifold;
  Answer orientable;
  Answer consistent;
  Answer outward;
};

/// Counts and measures of a mesh ("Characteristics" in doc/definitions.md). A count is of the
/// file's complex, except where it says that it counts the file's records.
struct Characteristics : ElementMeasures<Statistics> {
  /// The number of vertex records, orphans included.
  std::size_t vertices = 0;
  /// The number of faces in the file (of triangles, where polygons are fanned), including those
  /// that are left out of the complex.
  std::size_t faces = 0;
  std::size_t edges = 0;
  std::size_t components = 0;
  std::size_t edge_components = 0;
  std::size_t boundaries = 0;
  std::size_t border_edges = 0;
  std::size_t non_manifold_edges = 0;
  std::size_t non_manifold_vertices = 0;
  std::size_t pinched_vertices = 0;
  std::size_t flipped_edges = 0;
  std::size_t indistinguishable_vertices = 0;
  std::size_t indistinguishable_edges = 0;
  std::size_t zero_area_faces = 0;
  std::size_t duplicate_faces = 0;
  std::size_t intersecting_pairs = 0;
  std::size_t unwelded_pairs = 0;
  std::size_t intersecting_faces = 0;
  /// Tells whether the search for intersecting pairs ended at its time limit, so that their number
  /// is a lower bound.
  bool is_search_stopped = false;
  /// The box of the used vertices; empty (isEmpty()) if no face is in the complex.
  Box3 bounding_box;
  /// The area; infinite if it is too large for a double.
  double area = 0.0;
  Measure<double> volume;
  Measure<std::int64_t> genus;
  /// The sum of the genus of the components, if each has one; equal to genus unless orphans make
  /// that undefined.
  std::optional<std::int64_t> genus_of_components;
};

/// Counts and measures of one component of faces joined through shared vertices. If a value is
/// absent, the value of the mesh has the reason.
struct ComponentAnalysis {
  /// The lowest face record in it, by which reports name the component.
  Index first_face = 0;
  std::size_t faces = 0;
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t edge_components = 0;
  std::size_t boundaries = 0;
  std::size_t border_edges = 0;
  std::size_t non_manifold_edges = 0;
  std::size_t non_manifold_vertices = 0;
  std::size_t flipped_edges = 0;
  std::size_t zero_area_faces = 0;
  /// Counts the pairs that have at least one face in the component.
  std::size_t intersecting_pairs = 0;
  bool closed = false;
  bool manifold = false;
  std::optional<bool> orientable;
  std::optional<bool> consistent;
  std::optional<bool> outward;
  std::optional<std::int64_t> genus;
  std::optional<double> volume;
  double area = 0.0;
  Box3 bounding_box;
  /// The component that directly encloses this one, as an index into Analysis::components.
  std::optional<std::size_t> inside;
};

/// The measures of the faces, edges and vertices of one component.
using ComponentStatistics = ElementMeasures<Summary>;

/// A verdict on a mesh, with the reasons.
struct Goodness {
  bool good = false;
  /// Lists every reason why the mesh is not good, in the order of "Good" in doc/definitions.md; it
  /// is empty when the mesh is good.
  std::vector<std::string> reasons;
};

/// The single values from which the statistics of a mesh are computed.
using MeasuredValues = ElementMeasures<std::vector<double>>;

class PreparedMesh;

/// The result of analyze(): a plain value that reports render without measuring anything.
struct Analysis {
  /// The path of the file as the user named it.
  std::string path;
  Format format = Format::Mesh;
  Ids vertex_ids;
  Ids face_ids;
  std::size_t n_merged_points = 0;
  std::size_t n_polygons = 0;
  Integrity integrity;
  Attributes attributes;
  /// Tells whether characteristics is filled in. With Scope::AttributesOnly it holds nothing but
  /// the topological counts.
  bool has_characteristics = true;
  Characteristics characteristics;
  /// The components in order of their lowest face record; with Scope::AttributesOnly they have no
  /// measures.
  std::vector<ComponentAnalysis> components;
  /// The statistics of each component if the mesh has between 2 and kMaxComponentStatistics of
  /// them, else empty. (A single component has the statistics of the mesh.)
  std::vector<ComponentStatistics> component_statistics;
  static constexpr std::size_t kMaxComponentStatistics = 1000;
  /// The statistics of the curvature; present if MeshRequest::curvature is.
  std::optional<CurvatureStatistics> curvature;
  /// The verdict by thresholds; present if MeshRequest::goodness is.
  std::optional<Goodness> goodness;
  /// The verdict without thresholds; absent with Scope::AttributesOnly, unless
  /// MeshRequest::judge_fitness is set.
  std::optional<Goodness> fitness;
  Offenders offenders;
  /// The file itself; kept only if AnalysisOptions::keep_soup is set.
  std::shared_ptr<const Soup> soup;
  /// The mesh with its search structures; kept only if AnalysisOptions::keep_mesh says so.
  std::shared_ptr<const PreparedMesh> mesh;
  /// The measured values in no particular order; kept only if AnalysisOptions::keep_values is set.
  MeasuredValues values;
};

}  // namespace meshalyzer
