#include "meshalyzer/report/json/mesh_reader.h"

#include "meshalyzer/analysis/goodness.h"
#include "meshalyzer/report/json/bytes.h"
#include "meshalyzer/report/json/curvature.h"
#include "meshalyzer/report/json/non_finite.h"
#include "meshalyzer/report/json/offenders_reader.h"
#include "meshalyzer/report/json/point.h"
#include "meshalyzer/report/json/record_ids.h"
#include "meshalyzer/report/json/statistics.h"
#include "meshalyzer/report/json/tree.h"

namespace meshalyzer {
namespace {

/// What may be null.
template <typename Read>
auto optional(const JsonNode& node, const Read& read) {
  return node.is_null() ? std::nullopt : std::optional(read(node));
}

std::optional<bool> optional_truth(const JsonNode& node) {
  return optional(node, [](const JsonNode& n) { return n.truth(); });
}

std::optional<std::int64_t> optional_integer(const JsonNode& node) {
  return optional(node, [](const JsonNode& n) { return n.integer(); });
}

Format read_format(const JsonNode& node) {
  const std::string_view name = node.text();
  for (const Format format :
       {Format::Mesh, Format::Inria, Format::Obj, Format::Off, Format::Stl, Format::Ply}) {
    if (name == format_name(format)) {
      return format;
    }
  }
  node.refuse("no format of meshes");
}

Box3 read_box(const JsonNode& node) {
  return node.is_null() ? Box3()
                        : Box3(read_point(node.member("min")), read_point(node.member("max")));
}

Integrity read_integrity(const JsonNode& object) {
  return {.orphan_vertices = object.member("orphan_vertices").count(),
          .missing_vertices = object.member("missing_vertices").count(),
          .degenerate_faces = object.member("degenerate_faces").count(),
          .duplicate_vertex_indices = object.member("duplicate_vertex_indices").count(),
          .duplicate_face_indices = object.member("duplicate_face_indices").count(),
          .torn_lines = object.member("torn_lines").count(),
          .contiguous_vertices = object.member("contiguous_vertices").truth(),
          .contiguous_faces = object.member("contiguous_faces").truth()};
}

/// The offenders that a report names without -p too.
void read_first_breaks(const JsonNode& integrity, Offenders& offenders) {
  if (offenders.torn_lines.empty() && integrity.member("torn_lines").count() != 0) {
    offenders.torn_lines.push_back(integrity.member("first_torn_line").integer());
  }
  if (const std::optional<JsonNode> node = integrity.find("vertex_numbering")) {
    offenders.vertex_numbering = read_numbering(*node);
  }
  if (const std::optional<JsonNode> node = integrity.find("face_numbering")) {
    offenders.face_numbering = read_numbering(*node);
  }
}

std::string read_reason(const JsonNode& mesh, std::string_view name) {
  const std::optional<JsonNode> reason = mesh.member("undefined").find(name);
  return reason ? std::string(reason->text()) : std::string();
}

Answer read_answer(const JsonNode& mesh, std::string_view name) {
  return {.value = optional_truth(mesh.member("attributes").member(name)),
          .reason = read_reason(mesh, name)};
}

Attributes read_attributes(const JsonNode& mesh) {
  return {.closed = read_answer(mesh, "closed"),
          .manifold = read_answer(mesh, "manifold"),
          .orientable = read_answer(mesh, "orientable"),
          .consistent = read_answer(mesh, "consistent"),
          .outward = read_answer(mesh, "outward")};
}

void read_topology(const JsonNode& object, Characteristics& c) {
  c.vertices = object.member("vertices").count();
  c.faces = object.member("faces").count();
  c.edges = object.member("edges").count();
  c.components = object.member("components").count();
  c.edge_components = object.member("edge_components").count();
  c.boundaries = object.member("boundaries").count();
  c.border_edges = object.member("border_edges").count();
  c.non_manifold_edges = object.member("non_manifold_edges").count();
  c.non_manifold_vertices = object.member("non_manifold_vertices").count();
  c.pinched_vertices = object.member("pinched_vertices").count();
  c.flipped_edges = object.member("flipped_edges").count();
}

void read_measured(const JsonNode& object, Characteristics& c) {
  c.indistinguishable_vertices = object.member("indistinguishable_vertices").count();
  c.indistinguishable_edges = object.member("indistinguishable_edges").count();
  c.zero_area_faces = object.member("zero_area_faces").count();
  c.duplicate_faces = object.member("duplicate_faces").count();
  c.intersecting_pairs = object.member("intersecting_pairs").count();
  c.unwelded_pairs = object.member("unwelded_pairs").count();
  c.intersecting_faces = object.member("intersecting_faces").count();
  c.area = read_real(object, "area");
  read_measures(object, static_cast<ElementMeasures<Statistics>&>(c));
}

Characteristics read_characteristics(const JsonNode& mesh, bool has_measures) {
  const JsonNode object = mesh.member("characteristics");
  Characteristics c;
  read_topology(object, c);
  c.bounding_box = read_box(object.member("bounding_box"));
  c.volume = {.value = find_real(object, "volume"), .reason = read_reason(mesh, "volume")};
  c.genus = {.value = optional_integer(object.member("genus")),
             .reason = read_reason(mesh, "genus")};
  c.genus_of_components = optional_integer(object.member("genus_of_components"));
  if (has_measures) {
    read_measured(object, c);
  }
  return c;
}

void read_component_topology(const JsonNode& object, ComponentAnalysis& component) {
  component.faces = object.member("faces").count();
  component.vertices = object.member("vertices").count();
  component.edges = object.member("edges").count();
  component.edge_components = object.member("edge_components").count();
  component.boundaries = object.member("boundaries").count();
  component.border_edges = object.member("border_edges").count();
  component.non_manifold_edges = object.member("non_manifold_edges").count();
  component.non_manifold_vertices = object.member("non_manifold_vertices").count();
  component.flipped_edges = object.member("flipped_edges").count();
  component.closed = object.member("closed").truth();
  component.manifold = object.member("manifold").truth();
  component.orientable = optional_truth(object.member("orientable"));
  component.consistent = optional_truth(object.member("consistent"));
  component.outward = optional_truth(object.member("outward"));
}

ComponentAnalysis read_component(const JsonNode& object, bool has_measures) {
  ComponentAnalysis component;
  component.first_face = read_id(object.member("first_face"));
  read_component_topology(object, component);
  component.genus = optional_integer(object.member("genus"));
  component.volume = find_real(object, "volume");
  component.bounding_box = read_box(object.member("bounding_box"));
  component.inside =
      optional(object.member("inside"), [](const JsonNode& node) { return node.count(); });
  if (has_measures) {
    component.zero_area_faces = object.member("zero_area_faces").count();
    component.intersecting_pairs = object.member("intersecting_pairs").count();
    component.area = read_real(object, "area");
  }
  return component;
}

void read_components(const JsonNode& list, Analysis& analysis) {
  for (JsonElements elements = list.elements(); !elements.at_end();) {
    const JsonNode object = elements.next();
    // Either all have statistics or none: a mesh of many components has none of each.
    if (has_measures(object)) {
      analysis.component_statistics.resize(analysis.components.size());
      read_measures(object, analysis.component_statistics.emplace_back());
    }
    analysis.components.push_back(read_component(object, analysis.has_characteristics));
  }
}

std::optional<Goodness> read_verdict(const JsonNode& object) {
  const std::optional<bool> good = optional_truth(object.member("good"));
  if (!good) {
    return std::nullopt;
  }
  Goodness verdict{*good, {}};
  for (JsonElements reasons = object.member("reasons").elements(); !reasons.at_end();) {
    verdict.reasons.emplace_back(reasons.next().text());
  }
  return verdict;
}

/// It follows from the characteristics where these are known; else it is written where it was asked
/// for.
std::optional<Goodness> read_fitness(const JsonNode& mesh, const Analysis& analysis) {
  if (analysis.has_characteristics) {
    return judge_fitness(analysis);
  }
  const std::optional<JsonNode> fitness = mesh.find("fitness");
  return fitness ? read_verdict(*fitness) : std::nullopt;
}

}  // namespace

Analysis read_mesh_json(std::string_view object_text) {
  const JsonTree tree(object_text);
  const JsonNode mesh = tree.root();
  Analysis analysis;
  analysis.path = read_bytes(mesh, "path");
  analysis.format = read_format(mesh.member("format"));
  analysis.n_merged_points = mesh.member("merged_points").count();
  analysis.n_polygons = mesh.member("polygons").count();
  analysis.integrity = read_integrity(mesh.member("integrity"));
  analysis.attributes = read_attributes(mesh);
  analysis.has_characteristics = !has_null_measures(mesh.member("characteristics"));
  analysis.characteristics = read_characteristics(mesh, analysis.has_characteristics);
  analysis.curvature = read_curvature(mesh.member("characteristics"));
  read_components(mesh.member("per_component"), analysis);
  analysis.goodness = read_verdict(mesh);
  analysis.fitness = read_fitness(mesh, analysis);
  if (const std::optional<JsonNode> offenders = mesh.find("offenders")) {
    analysis.offenders = read_offenders(*offenders);
  }
  read_first_breaks(mesh.member("integrity"), analysis.offenders);
  index_records(analysis);
  return analysis;
}

}  // namespace meshalyzer
