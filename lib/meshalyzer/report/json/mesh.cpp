#include "meshalyzer/report/json/mesh.h"

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/analysis/fields.h"
#include "meshalyzer/analysis/goodness.h"
#include "meshalyzer/analysis/offender_lists.h"
#include "meshalyzer/report/json/bytes.h"
#include "meshalyzer/report/json/curvature.h"
#include "meshalyzer/report/json/elements.h"
#include "meshalyzer/report/json/fields.h"
#include "meshalyzer/report/json/format.h"
#include "meshalyzer/report/json/offenders.h"
#include "meshalyzer/report/json/record_ids.h"
#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/statistics.h"
#include "meshalyzer/report/json/tree.h"
#include "meshalyzer/report/json/verdict.h"
#include "meshalyzer/report/json/writer.h"

namespace meshalyzer {
namespace {

void write_component(JsonWriter& json, const Analysis& analysis, std::size_t i) {
  const ComponentAnalysis& component = analysis.components[i];
  json.begin_object();
  json.member("first_face", analysis.face_ids.of(component.first_face));
  write_fields(json, component, kComponentFields, known_of(analysis));
  write_non_finite_fields(json, component, kComponentFields, known_of(analysis));
  if (i < analysis.component_statistics.size()) {
    write_measures(json, analysis.component_statistics[i]);
  }
  json.end_object();
}

/// Writes the list of all components, with their statistics if the analysis has them.
void write_components(JsonWriter& json, const Analysis& analysis) {
  json.begin_array();
  for (std::size_t i = 0; i < analysis.components.size(); ++i) {
    write_component(json, analysis, i);
  }
  json.end_array();
}

/// Reads the components that write_components() wrote into an analysis that is otherwise complete.
void read_components(const JsonNode& list, Analysis& analysis) {
  for (JsonElements elements = list.elements(); !elements.at_end();) {
    const JsonNode object = elements.next();
    // Either all components have statistics or none: a mesh with many components has none.
    if (has_measures(object)) {
      analysis.component_statistics.resize(analysis.components.size());
      read_measures(object, analysis.component_statistics.emplace_back());
    }
    ComponentAnalysis& component = analysis.components.emplace_back();
    component.first_face = read_id(object.member("first_face"));
    read_fields(object, component, kComponentFields, known_of(analysis));
  }
}

/// Defines "component".
void define_component(SchemaDefinitions& schema) {
  SchemaObject object{.description = "statistics are given if the mesh has 2 to 1000 components",
                      .members = {{"first_face", "id of its lowest face", schema_type::kInteger}}};
  append_members(object.members, ComponentAnalysis(), kComponentFields);
  object.members.push_back(non_finite_member());
  append_measures(object.members, "summary", SchemaMember::Presence::Sometimes);
  schema.define("component", object);
}

constexpr std::string_view kAtLeastKey = "intersecting_pairs_at_least";

/// Writes the first break in the numbering and the torn lines, which a report has even without the
/// other offenders.
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

void write_integrity(JsonWriter& json, const Analysis& analysis) {
  json.begin_object();
  write_fields(json, analysis.integrity, kIntegrityFields, Known::Always);
  write_first_breaks(json, analysis.offenders);
  json.end_object();
}

void define_integrity(SchemaDefinitions& schema) {
  constexpr auto kSometimes = SchemaMember::Presence::Sometimes;
  SchemaObject object{.description = "whether the records of the file are complete and consistent"};
  append_members(object.members, Integrity(), kIntegrityFields);
  object.members.push_back({"first_torn_line", "only where there are any",
                            R"("type": "integer", "minimum": 1)", kSometimes});
  for (const char* const key : {"vertex_numbering", "face_numbering"}) {
    object.members.push_back(
        {key, "only where it is broken", schema_reference("numbering"), kSometimes});
  }
  schema.define("integrity", object);
}

void write_attributes(JsonWriter& json, const Attributes& attributes) {
  json.begin_object();
  write_fields(json, attributes, kAttributeFields, Known::Always);
  json.end_object();
}

void define_attributes(SchemaDefinitions& schema) {
  SchemaObject object{.description = "null where \"undefined\" tells why"};
  append_members(object.members, Attributes(), kAttributeFields);
  schema.define("attributes", object);
}

/// Calls `visit` with the key and the reason of each field that may have no value.
template <typename Struct, typename Rows, typename Visit>
void for_each_reason(Struct& of, const Rows& rows, const Visit& visit) {
  for_each_row(rows, [&](const auto& row) {
    if constexpr (requires { (of.*row.member).reason; }) {
      visit(row.info.key, of.*row.member);
    }
  });
}

/// Writes the reason for each attribute and characteristic that is null.
void write_undefined(JsonWriter& json, const Analysis& analysis) {
  const auto write_reason = [&](std::string_view key, const auto& measure) {
    if (!measure.value && !measure.reason.empty()) {
      json.member(key, measure.reason);
    }
  };
  json.begin_object();
  for_each_reason(analysis.attributes, kAttributeFields, write_reason);
  for_each_reason(analysis.characteristics, kCharacteristicFields, write_reason);
  json.end_object();
}

void read_undefined(const JsonNode& object, Analysis& analysis) {
  const auto read_reason = [&](std::string_view key, auto& measure) {
    if (const std::optional<JsonNode> reason = object.find(key)) {
      measure.reason = reason->text();
    }
  };
  for_each_reason(analysis.attributes, kAttributeFields, read_reason);
  for_each_reason(analysis.characteristics, kCharacteristicFields, read_reason);
}

void write_characteristics(JsonWriter& json, const Analysis& analysis) {
  const Characteristics& c = analysis.characteristics;
  const Known known = known_of(analysis);
  json.begin_object();
  write_fields(json, c, kCharacteristicFields, known);
  if (c.is_search_stopped) json.member(kAtLeastKey, true);
  write_measures(json, analysis.has_characteristics ? &c : nullptr);
  if (analysis.curvature) {
    write_curvature(json, *analysis.curvature);
  }
  write_non_finite_fields(json, c, kCharacteristicFields, known);
  json.end_object();
}

void read_characteristics(const JsonNode& object, Analysis& analysis) {
  analysis.has_characteristics = !has_null_measures(object);
  read_fields(object, analysis.characteristics, kCharacteristicFields, known_of(analysis));
  if (analysis.has_characteristics) {
    ElementMeasures<Statistics>& measures = analysis.characteristics;
    read_measures(object, measures);
  }
  analysis.characteristics.is_search_stopped = object.find(kAtLeastKey).has_value();
  analysis.curvature = read_curvature(object);
}

void define_characteristics(SchemaDefinitions& schema) {
  SchemaObject object{.description = "what was counted and measured"};
  append_members(object.members, Characteristics(), kCharacteristicFields);
  object.members.push_back(
      {std::string(kAtLeastKey),
       "only where the search for intersecting pairs ended at its time limit: there are at least "
       "so many pairs and faces, in the mesh and in each of its components",
       schema_type::kTruth, SchemaMember::Presence::Sometimes});
  append_measures(object.members, "statistics", SchemaMember::Presence::Always);
  append_curvature_members(object.members);
  object.members.push_back(non_finite_member());
  schema.define("characteristics", object);
}

/// Writes the verdict without thresholds, only if it does not follow from other members.
void write_fitness(JsonWriter& json, const Analysis& analysis) {
  if (analysis.fitness && !analysis.has_characteristics) {
    json.key("fitness");
    json.begin_object();
    write_verdict_members(json, analysis.fitness);
    json.end_object();
  }
}

/// Reads the verdict without thresholds. It follows from the characteristics if these are known;
/// else it is written if it was requested.
std::optional<Goodness> read_fitness(const JsonNode& mesh, const Analysis& analysis) {
  if (analysis.has_characteristics) {
    return judge_fitness(analysis);
  }
  const std::optional<JsonNode> fitness = mesh.find("fitness");
  return fitness ? read_verdict_members(*fitness) : std::nullopt;
}

/// Returns the members from "path" to "polygons".
std::vector<SchemaMember> file_members() {
  std::vector<SchemaMember> members = path_members();
  const std::vector<SchemaMember> format = format_members();
  members.insert(members.end(), format.begin(), format.end());
  members.push_back({"merged_points", "STL: corners whose point occurred before, bit by bit",
                     schema_type::kCount});
  members.push_back({"polygons", "faces of more than three corners, each fanned into triangles",
                     schema_type::kCount});
  return members;
}

}  // namespace

void write_mesh_members(JsonWriter& json, const Analysis& analysis, JsonOffenders offenders) {
  write_bytes(json, "path", analysis.path);
  write_format(json, analysis.path, analysis.format);
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
  write_verdict(json, verdict_of(analysis));
  write_verdict_members(json, analysis.goodness);
  write_fitness(json, analysis);
  if (offenders == JsonOffenders::List || has_asked_lists(analysis.offenders)) {
    json.key("offenders");
    write_offenders(json, analysis, offenders);
  }
}

Analysis read_mesh_members(std::string_view object_text) {
  const JsonTree tree(object_text);
  const JsonNode mesh = tree.root();
  Analysis analysis;
  analysis.path = read_bytes(mesh, "path");
  analysis.format = read_format(mesh.member("format"));
  analysis.n_merged_points = mesh.member("merged_points").count();
  analysis.n_polygons = mesh.member("polygons").count();
  const JsonNode integrity = mesh.member("integrity");
  read_fields(integrity, analysis.integrity, kIntegrityFields, Known::Always);
  read_fields(mesh.member("attributes"), analysis.attributes, kAttributeFields, Known::Always);
  read_characteristics(mesh.member("characteristics"), analysis);
  read_undefined(mesh.member("undefined"), analysis);
  read_components(mesh.member("per_component"), analysis);
  analysis.goodness = read_verdict_members(mesh);
  analysis.fitness = read_fitness(mesh, analysis);
  if (const std::optional<JsonNode> offenders = mesh.find("offenders")) {
    analysis.offenders = read_offenders(*offenders);
  }
  read_first_breaks(integrity, analysis.offenders);
  index_records(analysis);
  return analysis;
}

void define_mesh(SchemaDefinitions& schema) {
  define_verdict(schema);
  define_integrity(schema);
  define_attributes(schema);
  define_characteristics(schema);
  define_component(schema);
  schema.define("fitness", {.description = "",
                            .members = {{"good", "", schema_type::kTruth},
                                        {"reasons", "", schema_type::kTexts}}});
  constexpr auto kSometimes = SchemaMember::Presence::Sometimes;
  SchemaObject mesh{.description = "", .members = file_members()};
  const std::vector<SchemaMember> parts{
      {"integrity", "", schema_reference("integrity")},
      {"attributes", "", schema_reference("attributes")},
      {"characteristics", "", schema_reference("characteristics")},
      {"undefined", "attribute or characteristic that has no value -> why",
       schema_type::kTextByKey},
      {"per_component", "by lowest face",
       R"("type": "array", "items": {"$ref": "#/$defs/component"})"},
      {"verdict",
       "by the thresholds where these were given, else without; good is null where the "
       "mesh was not judged",
       schema_reference("verdict")},
      {"good", "null where no thresholds were given", schema_type::kTruthOrNull},
      {"reasons", "why it is not good", schema_type::kTexts},
      {"fitness",
       "the parts of goodness that need no threshold; only where they were judged although the "
       "rest was left out",
       schema_reference("fitness"), kSometimes},
      {"offenders", "where asked for; with thresholds alone only the lists of what is beyond them",
       schema_reference("offenders"), kSometimes}};
  mesh.members.insert(mesh.members.end(), parts.begin(), parts.end());
  schema.define("mesh", mesh);
}

}  // namespace meshalyzer
