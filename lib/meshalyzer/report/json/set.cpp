#include "meshalyzer/report/json/set.h"

#include "meshalyzer/report/json/findings.h"
#include "meshalyzer/report/json/name.h"
#include "meshalyzer/report/json/non_finite.h"
#include "meshalyzer/report/json/statistics.h"
#include "meshalyzer/report/set_verdict.h"

#include <initializer_list>

namespace meshalyzer {
namespace {

void write_nulls(JsonWriter& json, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    json.key(name);
    json.null();
  }
}

void write_not_good(JsonWriter& json, const SetAnalysis& set) {
  json.key("not_good");
  json.begin_array();
  for (const UnfitMesh& mesh : set.not_good) {
    json.begin_array(JsonLayout::Row);
    json.value(std::string_view(json_name(set.names[mesh.mesh])));
    json.begin_array(JsonLayout::Row);
    for (const std::string& reason : mesh.reasons) {
      json.value(std::string_view(reason));
    }
    json.end_array();
    json.end_array();
  }
  json.end_array();
}

void write_totals(JsonWriter& json, const SetAnalysis& set) {
  const auto measured = [&](auto value) {
    return set.is_measured ? std::optional(value) : std::nullopt;
  };
  json.member("vertices", set.vertices);
  json.member("faces", set.faces);
  json.member("edges", set.edges);
  json.member("components", set.components);
  json.member("boundaries", set.boundaries);
  json.member("intersecting_pairs_within", measured(set.intersecting_pairs_within));
  json.member("area", measured(set.area));
  json.member("volume", set.is_measured ? set.volume.value : std::nullopt);
  if (set.is_measured) {
    write_non_finite(json, {{"area", set.area}, {"volume", set.volume.value.value_or(0.0)}});
  }
}

/// Why there is no volume, or what it is the volume of, and why there is no separation.
void write_undefined(JsonWriter& json, const SetAnalysis& set) {
  json.key("undefined");
  json.begin_object();
  if (!set.volume.reason.empty()) {
    json.member("volume", std::string_view(set.volume.reason));
  }
  if (!set.separation_reason.empty()) {
    json.member("separation", std::string_view(set.separation_reason));
  }
  json.end_object();
}

void write_intersections(JsonWriter& json, const SetAnalysis& set,
                         const std::function<void()>& on_row) {
  if (!set.intersections) {
    write_nulls(json,
                {"intersecting_pair_count", "contained", "partly_contained", "intersecting_pairs"});
    return;
  }
  FindingsWriter rows(json, set.names, on_row);
  json.member("intersecting_pair_count", set.intersections->pairs.size());
  json.key("contained");
  rows.contained(set.intersections->contained);
  json.key("partly_contained");
  rows.contained(set.intersections->partly_contained);
  json.key("intersecting_pairs");
  rows.pairs(set.intersections->pairs);
}

void write_options(JsonWriter& json, const SeparationOptions& options) {
  json.key("separation_options");
  json.begin_object(JsonLayout::Row);
  json.member("search_radius", options.search_radius);
  json.member("search_cone_degrees", options.search_cone_degrees);
  json.member("include_self", options.include_self);
  json.end_object();
}

/// An object with a member a mesh; `write` writes its value.
template <typename Write>
void write_by_mesh(JsonWriter& json, const SetAnalysis& set, const Write& write) {
  json.begin_object();
  for (const MeshSeparation& mesh : set.separation->meshes) {
    json.key(json_name(set.names[mesh.mesh]));
    write(mesh);
  }
  json.end_object();
}

void write_separation(JsonWriter& json, const SetAnalysis& set) {
  if (!set.separation) {
    write_nulls(json, {"separation_options", "separation_forced", "separation_all",
                       "separation_inside_count", "separation_without_closest_count",
                       "separation_inside", "separation_without_closest", "separation"});
    return;
  }
  const SetSeparation& separation = *set.separation;
  write_options(json, separation.options);
  json.member("separation_forced", separation.is_forced);
  json.key("separation_all");
  write_statistics(json, separation.all);
  json.member("separation_inside_count", separation.inside);
  json.member("separation_without_closest_count", separation.without_closest);
  json.key("separation_inside");
  write_by_mesh(json, set, [&](const MeshSeparation& mesh) { json.value(mesh.inside); });
  json.key("separation_without_closest");
  write_by_mesh(json, set, [&](const MeshSeparation& mesh) { json.value(mesh.without_closest); });
  json.key("separation");
  write_by_mesh(json, set,
                [&](const MeshSeparation& mesh) { write_statistics(json, mesh.distance); });
}

}  // namespace

void write_set_members(JsonWriter& json, const SetAnalysis& set,
                       const std::function<void()>& on_row) {
  json.member("meshes", set.meshes);
  json.member("unreadable", set.unreadable);
  json.member("good", set.good);
  write_not_good(json, set);
  json.member("is_good", is_good(set));
  write_totals(json, set);
  write_measures(json, set.statistics ? &*set.statistics : nullptr);
  write_undefined(json, set);
  write_intersections(json, set, on_row);
  write_separation(json, set);
}

}  // namespace meshalyzer
