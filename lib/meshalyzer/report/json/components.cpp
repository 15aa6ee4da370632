#include "meshalyzer/report/json/components.h"

#include "meshalyzer/analysis/fields.h"
#include "meshalyzer/report/json/elements.h"
#include "meshalyzer/report/json/fields.h"
#include "meshalyzer/report/json/statistics.h"

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

}  // namespace

void write_components(JsonWriter& json, const Analysis& analysis) {
  json.begin_array();
  for (std::size_t i = 0; i < analysis.components.size(); ++i) {
    write_component(json, analysis, i);
  }
  json.end_array();
}

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

void define_component(SchemaDefinitions& schema) {
  SchemaObject object{
      .description = "statistics are told where the mesh has 2 to 1000 components",
      .members = {{"first_face", "id of its lowest face", std::string(schema_type::kInteger)}}};
  append_members(object.members, ComponentAnalysis(), kComponentFields);
  object.members.push_back(non_finite_member());
  append_measures(object.members, "summary", SchemaMember::Presence::Sometimes);
  schema.define("component", object);
}

}  // namespace meshalyzer
