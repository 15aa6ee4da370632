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

/// A yes, a no, or nothing and the reason why there is no answer.
struct Answer {
  std::optional<bool> value;
  /// Why there is no answer, in words that follow "undefined: "; empty where there is one.
  std::string reason;
};

/// A number, or nothing and the reason why there is none.
template <typename T>
struct Measure {
  std::optional<T> value;
  std::string reason;
};

/// Does the file say what it means? (contract 1, Integrity)
struct Integrity {
  std::size_t orphan_vertices = 0;
  /// Distinct ids.
  std::size_t missing_vertices = 0;
  std::size_t degenerate_faces = 0;
  /// Records beyond the first of their id.
  std::size_t duplicate_vertex_indices = 0;
  std::size_t duplicate_face_indices = 0;
  /// `.mesh`: lines that begin with a number, the remains of a torn record; they are no records
  /// (Soup::torn_lines).
  std::size_t torn_lines = 0;
  bool contiguous_vertices = true;
  bool contiguous_faces = true;
};

/// The five attributes (contract 1, Attributes).
struct Attributes {
  Answer closed;
  Answer manifold;
  Answer orientable;
  Answer consistent;
  Answer outward;
};

/// What is measured (contract 1, Characteristics). Counts are of the file's records where it says
/// so, else of the complex.
struct Characteristics : ElementMeasures<Statistics> {
  /// Vertex records, orphans included.
  std::size_t vertices = 0;
  /// Faces of the file (triangles, after fanning), those left out of the complex included.
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
  /// Empty (isEmpty()) where no face is in the complex.
  Box3 bounding_box;
  /// Infinite where it is too large for a double.
  double area = 0.0;
  Measure<double> volume;
  Measure<std::int64_t> genus;
  /// The genus of the components summed, where each has one; the same as genus but when orphans
  /// forbid that.
  std::optional<std::int64_t> genus_of_components;
};

/// What is known of one component: faces joined through shared vertices. No value: see the mesh's
/// for the reason.
struct ComponentAnalysis {
  /// The lowest face record in it: a name for the component that a person can look up.
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
  /// Pairs with at least one face in the component.
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
  /// The component that directly encloses this one, as index into Analysis::components.
  std::optional<std::size_t> inside;
};

/// The measures of the faces, edges and vertices of one component.
using ComponentStatistics = ElementMeasures<Summary>;

/// A verdict.
struct Goodness {
  bool good = false;
  /// Every reason why it is not, in the order of contract 3; empty when good.
  std::vector<std::string> reasons;
};

/// The values that the statistics of a mesh are of.
using MeasuredValues = ElementMeasures<std::vector<double>>;

class PreparedMesh;

/// All that is known of one mesh. A plain value: reports render it, nothing measures after it.
struct Analysis {
  /// As the user named it.
  std::string path;
  Format format = Format::Mesh;
  Ids vertex_ids;
  Ids face_ids;
  std::size_t n_merged_points = 0;
  std::size_t n_polygons = 0;
  Integrity integrity;
  Attributes attributes;
  /// False when only the attributes were asked for (-a): then all but the topological counts is
  /// empty.
  bool has_characteristics = true;
  Characteristics characteristics;
  /// In order of their lowest face record; without measures when only the attributes were asked
  /// for.
  std::vector<ComponentAnalysis> components;
  /// One a component where the mesh has 2 ... kMaxComponentStatistics of them, else empty (with one
  /// component they are those of the mesh).
  std::vector<ComponentStatistics> component_statistics;
  static constexpr std::size_t kMaxComponentStatistics = 1000;
  /// Present with --curvature.
  std::optional<CurvatureStatistics> curvature;
  /// Present with -g.
  std::optional<Goodness> goodness;
  /// The parts of goodness that need no threshold; absent when only the attributes were asked for.
  std::optional<Goodness> fitness;
  Offenders offenders;
  /// The file itself; only kept where a report will show places (-q, --html, --export).
  std::shared_ptr<const Soup> soup;
  /// The file with what was built for it; only kept where a picture will be made of it.
  std::shared_ptr<const PreparedMesh> mesh;
  /// In no particular order; only kept for the statistics of a set.
  MeasuredValues values;
};

}  // namespace meshalyzer
