#include "meshalyzer/report/json.h"

#include "meshalyzer/report/asked_lists.h"
#include "meshalyzer/report/json_offenders.h"
#include "meshalyzer/report/json_writer.h"

#include <algorithm>

namespace meshalyzer {
namespace {

void write_point(JsonWriter& json, const Vec3& point) {
  json.begin_array(JsonLayout::Row);
  json.value(point.x());
  json.value(point.y());
  json.value(point.z());
  json.end_array();
}

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

void write_figures(JsonWriter& json, const Summary& summary) {
  const auto figure = [&](double value) {
    return summary.count == 0 ? std::nullopt : std::optional(value);
  };
  json.member("count", summary.count);
  json.member("infinite", summary.infinite);
  json.member("min", figure(summary.min));
  json.member("max", figure(summary.max));
  json.member("mean", figure(summary.mean));
  json.member("median", figure(summary.median));
  json.member("variance", figure(summary.variance));
  json.member("total", figure(summary.total));
}

void write_histogram(JsonWriter& json, const Histogram& histogram) {
  json.begin_object();
  json.key("edges");
  json.begin_array(JsonLayout::Row);
  for (const double edge : histogram.edges) {
    json.value(edge);
  }
  json.end_array();
  json.key("counts");
  json.begin_array(JsonLayout::Row);
  for (const std::size_t count : histogram.counts) {
    json.value(count);
  }
  json.end_array();
  json.end_object();
}

void write_statistics(JsonWriter& json, const Statistics& statistics) {
  json.begin_object();
  write_figures(json, statistics);
  json.key("histogram");
  if (statistics.count == 0) {
    json.null();
  } else {
    write_histogram(json, statistics.histogram);
  }
  json.end_object();
}

void write_summary(JsonWriter& json, const Summary& summary) {
  json.begin_object(JsonLayout::Row);
  write_figures(json, summary);
  json.end_object();
}

void write_integrity(JsonWriter& json, const Integrity& integrity) {
  json.begin_object();
  json.member("orphan_vertices", integrity.orphan_vertices);
  json.member("missing_vertices", integrity.missing_vertices);
  json.member("degenerate_faces", integrity.degenerate_faces);
  json.member("duplicate_vertex_indices", integrity.duplicate_vertex_indices);
  json.member("duplicate_face_indices", integrity.duplicate_face_indices);
  json.member("torn_lines", integrity.torn_lines);
  json.member("contiguous_vertices", integrity.contiguous_vertices);
  json.member("contiguous_faces", integrity.contiguous_faces);
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

void write_measures(JsonWriter& json, const Characteristics& c) {
  json.member("indistinguishable_vertices", c.indistinguishable_vertices);
  json.member("indistinguishable_edges", c.indistinguishable_edges);
  json.member("zero_area_faces", c.zero_area_faces);
  json.member("duplicate_faces", c.duplicate_faces);
  json.member("intersecting_pairs", c.intersecting_pairs);
  json.member("unwelded_pairs", c.unwelded_pairs);
  json.member("intersecting_faces", c.intersecting_faces);
  json.member("area", c.area);
  const auto statistics = [&](std::string_view name, const Statistics& values) {
    json.key(name);
    write_statistics(json, values);
  };
  statistics("vertex_valence", c.vertex_valence);
  statistics("face_area", c.face_area);
  statistics("aspect_ratio", c.aspect_ratio);
  statistics("edge_length", c.edge_length);
  statistics("edge_angle", c.edge_angle);
}

/// What -a leaves out keeps its keys, so that a program need not ask which report it has.
void write_uncomputed_measures(JsonWriter& json) {
  for (const std::string_view name :
       {"indistinguishable_vertices", "indistinguishable_edges", "zero_area_faces",
        "duplicate_faces", "intersecting_pairs", "unwelded_pairs", "intersecting_faces", "area",
        "vertex_valence", "face_area", "aspect_ratio", "edge_length", "edge_angle"}) {
    json.key(name);
    json.null();
  }
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

void write_component_statistics(JsonWriter& json, const ComponentStatistics& statistics) {
  const auto summary = [&](std::string_view name, const Summary& values) {
    json.key(name);
    write_summary(json, values);
  };
  summary("vertex_valence", statistics.vertex_valence);
  summary("face_area", statistics.face_area);
  summary("aspect_ratio", statistics.aspect_ratio);
  summary("edge_length", statistics.edge_length);
  summary("edge_angle", statistics.edge_angle);
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
  if (i < analysis.component_statistics.size()) {
    write_component_statistics(json, analysis.component_statistics[i]);
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

void write_goodness(JsonWriter& json, const std::optional<Goodness>& goodness) {
  json.key("good");
  if (goodness) {
    json.value(goodness->good);
  } else {
    json.null();
  }
  json.key("reasons");
  json.begin_array();
  if (goodness) {
    for (const std::string& reason : goodness->reasons) {
      json.value(std::string_view(reason));
    }
  }
  json.end_array();
}

void write_mesh(JsonWriter& json, const Analysis& analysis, JsonOffenders offenders) {
  json.begin_object();
  json.member("path", std::string_view(analysis.path));
  json.member("format", format_name(analysis.format));
  json.member("merged_points", analysis.n_merged_points);
  json.member("polygons", analysis.n_polygons);
  json.key("integrity");
  write_integrity(json, analysis.integrity);
  json.key("attributes");
  write_attributes(json, analysis.attributes);
  json.key("characteristics");
  json.begin_object();
  write_topology(json, analysis.characteristics);
  write_place(json, analysis.characteristics);
  if (analysis.has_characteristics) {
    write_measures(json, analysis.characteristics);
  } else {
    write_uncomputed_measures(json);
  }
  json.end_object();
  json.key("undefined");
  write_undefined(json, analysis);
  json.key("per_component");
  write_components(json, analysis);
  write_goodness(json, analysis.goodness);
  if (offenders == JsonOffenders::List || has_asked_lists(analysis.offenders)) {
    json.key("offenders");
    write_offenders(json, analysis, offenders);
  }
  json.end_object();
}

/// A sum over meshes of which one was not analysed in full (-a) would be none: it is null.
void write_set(JsonWriter& json, const SetAnalysis& set, std::span<const Analysis> meshes) {
  const bool is_measured = std::all_of(
      meshes.begin(), meshes.end(), [](const Analysis& mesh) { return mesh.has_characteristics; });
  const auto measured = [&](auto value) {
    return is_measured ? std::optional(value) : std::nullopt;
  };
  json.begin_object();
  json.member("meshes", set.meshes);
  json.member("unreadable", set.unreadable);
  json.member("good", set.good);
  json.member("vertices", set.vertices);
  json.member("faces", set.faces);
  json.member("edges", set.edges);
  json.member("components", set.components);
  json.member("boundaries", set.boundaries);
  json.member("intersecting_pairs_within", measured(set.intersecting_pairs_within));
  json.member("area", measured(set.area));
  json.member("volume", set.volume.value);
  // Between meshes nothing is computed yet.
  for (const std::string_view name : {"intersecting_pairs", "intersecting_pair_count", "contained",
                                      "separation", "separation_all"}) {
    json.key(name);
    json.null();
  }
  json.end_object();
}

}  // namespace

std::string json_report(std::span<const Analysis> meshes, const SetAnalysis* set,
                        JsonOffenders offenders) {
  JsonWriter json;
  json.begin_object();
  json.member("schema", std::string_view("meshalyzer-report/1"));
  json.member("version", std::string_view(MESHALYZER_VERSION));
  json.key("meshes");
  json.begin_array();
  for (const Analysis& analysis : meshes) {
    write_mesh(json, analysis, offenders);
  }
  json.end_array();
  if (set != nullptr) {
    json.key("set");
    write_set(json, *set, meshes);
  }
  json.end_object();
  return json.take();
}

}  // namespace meshalyzer
