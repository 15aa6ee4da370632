#include "meshalyzer/report/json/mesh.h"

#include "meshalyzer/report/asked_lists.h"
#include "meshalyzer/report/json/bytes.h"
#include "meshalyzer/report/json/curvature.h"
#include "meshalyzer/report/json/non_finite.h"
#include "meshalyzer/report/json/offenders.h"
#include "meshalyzer/report/json/point.h"
#include "meshalyzer/report/json/statistics.h"

namespace meshalyzer {
namespace {

void write_box(JsonWriter& json, const Box3& box) {
  if (box.isEmpty()) {
    json.null();
    return;
  }
  json.begin_object(JsonLayout::Row);
  json.key("min");
  write_point(json, box.min());
  json.key("max");
  write_point(json, box.max());
  json.end_object();
}

/// What a report says of broken numbering and torn lines without -p too.
void write_first_breaks(JsonWriter& json, const Offenders& offenders) {
  if (!offenders.torn_lines.empty()) {
    json.member("first_torn_line", offenders.torn_lines.front());
  }
  if (offenders.vertex_numbering) {
    json.key("vertex_numbering");
    write_numbering(json, *offenders.vertex_numbering);
  }
  if (offenders.face_numbering) {
    json.key("face_numbering");
    write_numbering(json, *offenders.face_numbering);
  }
}

void write_integrity(JsonWriter& json, const Analysis& analysis) {
  const Integrity& integrity = analysis.integrity;
  json.begin_object();
  json.member("orphan_vertices", integrity.orphan_vertices);
  json.member("missing_vertices", integrity.missing_vertices);
  json.member("degenerate_faces", integrity.degenerate_faces);
  json.member("duplicate_vertex_indices", integrity.duplicate_vertex_indices);
  json.member("duplicate_face_indices", integrity.duplicate_face_indices);
  json.member("torn_lines", integrity.torn_lines);
  json.member("contiguous_vertices", integrity.contiguous_vertices);
  json.member("contiguous_faces", integrity.contiguous_faces);
  write_first_breaks(json, analysis.offenders);
  json.end_object();
}

void write_attributes(JsonWriter& json, const Attributes& attributes) {
  json.begin_object();
  json.member("closed", attributes.closed.value);
  json.member("manifold", attributes.manifold.value);
  json.member("orientable", attributes.orientable.value);
  json.member("consistent", attributes.consistent.value);
  json.member("outward", attributes.outward.value);
  json.end_object();
}

/// Of each attribute and characteristic that is null: why.
void write_undefined(JsonWriter& json, const Analysis& analysis) {
  const auto reason = [&](std::string_view name, const auto& measure) {
    if (!measure.value && !measure.reason.empty()) {
      json.member(name, std::string_view(measure.reason));
    }
  };
  json.begin_object();
  reason("closed", analysis.attributes.closed);
  reason("manifold", analysis.attributes.manifold);
  reason("orientable", analysis.attributes.orientable);
  reason("consistent", analysis.attributes.consistent);
  reason("outward", analysis.attributes.outward);
  reason("volume", analysis.characteristics.volume);
  reason("genus", analysis.characteristics.genus);
  json.end_object();
}

void write_topology(JsonWriter& json, const Characteristics& c) {
  json.member("vertices", c.vertices);
  json.member("faces", c.faces);
  json.member("edges", c.edges);
  json.member("components", c.components);
  json.member("edge_components", c.edge_components);
  json.member("boundaries", c.boundaries);
  json.member("border_edges", c.border_edges);
  json.member("non_manifold_edges", c.non_manifold_edges);
  json.member("non_manifold_vertices", c.non_manifold_vertices);
  json.member("pinched_vertices", c.pinched_vertices);
  json.member("flipped_edges", c.flipped_edges);
}

void write_place(JsonWriter& json, const Characteristics& c) {
  json.key("bounding_box");
  write_box(json, c.bounding_box);
  json.member("volume", c.volume.value);
  json.member("genus", c.genus.value);
  json.member("genus_of_components", c.genus_of_components);
}

void write_measured(JsonWriter& json, const Characteristics& c) {
  json.member("indistinguishable_vertices", c.indistinguishable_vertices);
  json.member("indistinguishable_edges", c.indistinguishable_edges);
  json.member("zero_area_faces", c.zero_area_faces);
  json.member("duplicate_faces", c.duplicate_faces);
  json.member("intersecting_pairs", c.intersecting_pairs);
  json.member("unwelded_pairs", c.unwelded_pairs);
  json.member("intersecting_faces", c.intersecting_faces);
  json.member("area", c.area);
  write_measures(json, &c);
}

/// What -a leaves out keeps its keys, so that a program need not ask which report it has.
void write_uncomputed_measures(JsonWriter& json) {
  for (const std::string_view name :
       {"indistinguishable_vertices", "indistinguishable_edges", "zero_area_faces",
        "duplicate_faces", "intersecting_pairs", "unwelded_pairs", "intersecting_faces", "area"}) {
    json.key(name);
    json.null();
  }
  write_measures(json, nullptr);
}

void write_characteristics(JsonWriter& json, const Analysis& analysis) {
  const Characteristics& c = analysis.characteristics;
  json.begin_object();
  write_topology(json, c);
  write_place(json, c);
  if (analysis.has_characteristics) {
    write_measured(json, c);
  } else {
    write_uncomputed_measures(json);
  }
  if (analysis.curvature) {
    write_curvature(json, *analysis.curvature);
  }
  write_non_finite(json, {{"area", analysis.has_characteristics ? c.area : 0.0},
                          {"volume", c.volume.value.value_or(0.0)}});
  json.end_object();
}

void write_component_topology(JsonWriter& json, const ComponentAnalysis& component) {
  json.member("faces", component.faces);
  json.member("vertices", component.vertices);
  json.member("edges", component.edges);
  json.member("edge_components", component.edge_components);
  json.member("boundaries", component.boundaries);
  json.member("border_edges", component.border_edges);
  json.member("non_manifold_edges", component.non_manifold_edges);
  json.member("non_manifold_vertices", component.non_manifold_vertices);
  json.member("flipped_edges", component.flipped_edges);
  json.member("closed", component.closed);
  json.member("manifold", component.manifold);
  json.member("orientable", component.orientable);
  json.member("consistent", component.consistent);
  json.member("outward", component.outward);
}

void write_component(JsonWriter& json, const Analysis& analysis, std::size_t i) {
  const ComponentAnalysis& component = analysis.components[i];
  const auto measured = [&](auto value) {
    return analysis.has_characteristics ? std::optional(value) : std::nullopt;
  };
  json.begin_object();
  json.member("first_face", analysis.face_ids.of(component.first_face));
  write_component_topology(json, component);
  json.member("zero_area_faces", measured(component.zero_area_faces));
  json.member("intersecting_pairs", measured(component.intersecting_pairs));
  json.member("genus", component.genus);
  json.member("volume", component.volume);
  json.member("area", measured(component.area));
  json.key("bounding_box");
  write_box(json, component.bounding_box);
  json.member("inside", component.inside);
  write_non_finite(json, {{"area", measured(component.area).value_or(0.0)},
                          {"volume", component.volume.value_or(0.0)}});
  if (i < analysis.component_statistics.size()) {
    write_measures(json, analysis.component_statistics[i]);
  }
  json.end_object();
}

void write_components(JsonWriter& json, const Analysis& analysis) {
  json.begin_array();
  for (std::size_t i = 0; i < analysis.components.size(); ++i) {
    write_component(json, analysis, i);
  }
  json.end_array();
}

void write_verdict(JsonWriter& json, const std::optional<Goodness>& verdict) {
  json.member("good", verdict ? std::optional(verdict->good) : std::nullopt);
  json.key("reasons");
  json.begin_array();
  if (verdict) {
    for (const std::string& reason : verdict->reasons) {
      json.value(std::string_view(reason));
    }
  }
  json.end_array();
}

/// Only where it does not follow from what else is written.
void write_fitness(JsonWriter& json, const Analysis& analysis) {
  if (analysis.fitness && !analysis.has_characteristics) {
    json.key("fitness");
    json.begin_object();
    write_verdict(json, analysis.fitness);
    json.end_object();
  }
}

}  // namespace

void write_mesh_members(JsonWriter& json, const Analysis& analysis, JsonOffenders offenders) {
  write_bytes(json, "path", analysis.path);
  json.member("format", format_name(analysis.format));
  json.member("merged_points", analysis.n_merged_points);
  json.member("polygons", analysis.n_polygons);
  json.key("integrity");
  write_integrity(json, analysis);
  json.key("attributes");
  write_attributes(json, analysis.attributes);
  json.key("characteristics");
  write_characteristics(json, analysis);
  json.key("undefined");
  write_undefined(json, analysis);
  json.key("per_component");
  write_components(json, analysis);
  write_verdict(json, analysis.goodness);
  write_fitness(json, analysis);
  if (offenders == JsonOffenders::List || has_asked_lists(analysis.offenders)) {
    json.key("offenders");
    write_offenders(json, analysis, offenders);
  }
}

}  // namespace meshalyzer
