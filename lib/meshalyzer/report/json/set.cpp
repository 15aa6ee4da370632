#include "meshalyzer/report/json/set.h"

#include "meshalyzer/report/json/fields.h"
#include "meshalyzer/report/json/findings.h"
#include "meshalyzer/report/json/name.h"
#include "meshalyzer/report/json/non_finite.h"
#include "meshalyzer/report/json/statistics.h"
#include "meshalyzer/report/json/verdict.h"
#include "meshalyzer/report/set_verdict.h"
#include "meshalyzer/set/set_counts.h"

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
    json.value(json_name(set.names[mesh.mesh]));
    json.array(mesh.reasons);
    json.end_array();
  }
  json.end_array();
}

/// Returns the key of the member that tells that a count is only a lower bound.
std::string at_least_key(const SetCount& count) {
  return std::string(count.info.key).append("_at_least");
}

void write_totals(JsonWriter& json, const SetAnalysis& set) {
  const auto measured = [&](auto value) {
    return set.is_measured ? std::optional(value) : std::nullopt;
  };
  for (const SetCount& count : kSetCounts) {
    const bool is_known = count.known == Known::Always || set.is_measured;
    json.member(count.info.key, is_known ? std::optional(set.*count.total) : std::nullopt);
    if (is_known && count.is_at_least_of(set)) json.member(at_least_key(count), true);
  }
  json.member("area", measured(set.area));
  json.member("volume", set.is_measured ? set.volume.value : std::nullopt);
  if (set.is_measured) {
    write_non_finite(json, {{"area", set.area}, {"volume", set.volume.value.value_or(0.0)}});
  }
}

/// Writes the reasons why there is no volume, or which meshes it excludes, and why there is no
/// separation.
void write_undefined(JsonWriter& json, const SetAnalysis& set) {
  json.key("undefined");
  json.begin_object();
  if (!set.volume.reason.empty()) {
    json.member("volume", set.volume.reason);
  }
  if (!set.separation_reason.empty()) {
    json.member("separation", set.separation_reason);
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
  const std::size_t n_pairs = set.intersections->n_pairs();
  json.member("intersecting_pair_count", n_pairs);
  if (set.intersections->is_search_stopped) json.member("intersecting_pairs_at_least", true);
  json.key("contained");
  rows.contained(set.intersections->contained);
  json.key("partly_contained");
  rows.contained(set.intersections->partly_contained);
  if (set.intersections->is_search_stopped) json.member("contained_at_least", true);
  json.key("intersecting_pairs");
  rows.pairs(set.intersections->pairs);
  if (const std::size_t n_listed = set.intersections->pairs.size(); n_listed < n_pairs) {
    json.member("intersecting_pairs_unlisted", n_pairs - n_listed);
  }
}

void write_options(JsonWriter& json, const SeparationOptions& options) {
  json.key("separation_options");
  json.begin_object(JsonLayout::Row);
  json.member("search_radius", options.search_radius);
  json.member("search_cone_degrees", options.search_cone_degrees);
  json.member("include_self", options.include_self);
  json.end_object();
}

/// Writes an object with one member for each mesh; `write` writes its value.
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
  json.key(kSeparationDistance.info.key);
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

// The members of the schema are in the order of the report.

using Members = std::vector<SchemaMember>;

void append(Members& to, const Members& from) {
  to.insert(to.end(), from.begin(), from.end());
}

Members verdict_members() {
  return {
      {"closest", "where separation was asked for: of each mesh a row a vertex that a face uses",
       R"("type": ["object", "null"], "additionalProperties": )"
       R"({"type": "array", "items": {"$ref": "#/$defs/closest"}})"},
      {"meshes", "those that could be read", schema_type::kCount},
      {"unreadable", "files that could not be read", schema_type::kCount},
      {"good",
       "meshes that are good, without thresholds by the parts of goodness that need none; "
       "null where only the attributes were asked for",
       schema_type::kCountOrNull},
      {"not_good", "meshes that are not, and files that could not be read: name, reasons",
       R"("type": "array", "items": {"type": "array", "minItems": 2, "maxItems": 2, )"
       R"("prefixItems": [{"$ref": "#/$defs/name"}, )"
       R"({"type": "array", "items": {"type": "string"}}]})"},
      {"is_good",
       "whether every mesh is good and, where that was asked for, none intersects or is inside "
       "another; null where only the attributes were asked for",
       schema_type::kTruthOrNull},
      {"verdict", "the same, and why the set is not good", schema_reference("verdict")}};
}

Members total_members() {
  Members members;
  for (const SetCount& count : kSetCounts) {
    members.push_back({.key = std::string(count.info.key),
                       .description = description_of(count.info, count.known),
                       .type = type_of(std::size_t{0}, count.known)});
    if (count.is_at_least != nullptr) {
      members.push_back(
          {at_least_key(count),
           "only where a search within a mesh ended at its time limit: there are at least so many",
           schema_type::kTruth, SchemaMember::Presence::Sometimes});
    }
  }
  members.push_back({"area", "null where only the attributes were asked for", schema_type::kReal});
  members.push_back({"volume",
                     "of the meshes that have one; null where only the attributes were asked for",
                     schema_type::kReal});
  members.push_back(non_finite_member());
  append_measures(members, "statistics", SchemaMember::Presence::Always);
  members.push_back({"undefined",
                     "volume -> which meshes have none; separation -> why it was not measured",
                     schema_type::kTextByKey});
  return members;
}

Members intersection_members() {
  return {{"intersecting_pair_count", "null where intersections were not asked for",
           schema_type::kCountOrNull},
          {"intersecting_pairs_at_least",
           "only where the search ended at its time limit: there are at least so many",
           schema_type::kTruth, SchemaMember::Presence::Sometimes},
          {"contained", "meshes inside another one", schema_reference("contained")},
          {"partly_contained", "meshes some components of which are inside another one",
           schema_reference("contained")},
          {"contained_at_least",
           "only where the search ended at its time limit: more meshes may be inside another one, "
           "wholly or partly",
           schema_type::kTruth, SchemaMember::Presence::Sometimes},
          {"intersecting_pairs", "", schema_reference("set_pairs")},
          {"intersecting_pairs_unlisted", "how many pairs the list leaves out, where it is cut",
           schema_type::kCount, SchemaMember::Presence::Sometimes}};
}

Members separation_members() {
  SchemaMember all = statistics_member(kSeparationDistance);
  all.description += "; null as separation";
  return {{"separation_options", "which points counted; null as separation",
           schema_reference("separation_options")},
          {"separation_forced", "measured although a mesh is not good; null as separation",
           schema_type::kTruthOrNull},
          all,
          {"separation_inside_count", "the sum of separation_inside", schema_type::kCountOrNull},
          {"separation_without_closest_count", "the sum of separation_without_closest",
           schema_type::kCountOrNull},
          {"separation_inside", "name -> vertices that lie inside another mesh; null as separation",
           schema_reference("count_by_mesh")},
          {"separation_without_closest",
           "name -> vertices with nothing within the search radius and cone; null as separation",
           schema_reference("count_by_mesh")},
          {"separation",
           "name -> statistics of the distances, of each mesh with a face; null where it was not "
           "asked for, or where \"undefined\" tells why",
           R"("type": ["object", "null"], "additionalProperties": )"
           R"({"$ref": "#/$defs/statistics"})"}};
}

}  // namespace

void write_set_members(JsonWriter& json, const SetAnalysis& set,
                       const std::function<void()>& on_row) {
  json.member("meshes", set.meshes);
  json.member("unreadable", set.unreadable);
  json.member("good", set.good);
  write_not_good(json, set);
  const std::optional<Goodness> verdict = set_verdict(set);
  json.member("is_good", verdict ? std::optional(verdict->good) : std::nullopt);
  write_verdict(json, verdict);
  write_totals(json, set);
  write_measures(json, set.statistics ? &*set.statistics : nullptr);
  write_undefined(json, set);
  write_intersections(json, set, on_row);
  write_separation(json, set);
}

void define_set(SchemaDefinitions& schema) {
  define_findings(schema);
  schema.define("count_by_mesh", "",
                R"("type": ["object", "null"], "additionalProperties": )"
                R"({"type": "integer", "minimum": 0})");
  schema.define("separation_options", {.description = "",
                                       .members = {{"search_radius", "", schema_type::kReal},
                                                   {"search_cone_degrees", "", schema_type::kReal},
                                                   {"include_self", "", schema_type::kReal}},
                                       .null = SchemaObject::Null::Sometimes});
  SchemaObject set{.description = "what is known of all meshes together, and between them",
                   .members = verdict_members()};
  for (const Members& members : {total_members(), intersection_members(), separation_members()}) {
    append(set.members, members);
  }
  schema.define("set", set);
}

}  // namespace meshalyzer
