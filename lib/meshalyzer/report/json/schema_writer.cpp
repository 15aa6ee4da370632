#include "meshalyzer/report/json/schema_writer.h"

namespace meshalyzer {
namespace {

void write_type(JsonWriter& json, std::string_view description, std::string_view type) {
  json.begin_object(JsonLayout::Row);
  if (!description.empty()) {
    json.member("description", description);
  }
  json.verbatim(type);
  json.end_object();
}

/// Writes the keywords of an object; the caller has begun it.
void write_schema(JsonWriter& json, const SchemaObject& object) {
  if (!object.description.empty()) {
    json.member("description", object.description);
  }
  json.verbatim(object.null == SchemaObject::Null::Never ? R"("type": "object")"
                                                         : R"("type": ["object", "null"])");
  if (object.others == SchemaObject::Others::Forbidden) {
    json.member("additionalProperties", false);
  }
  json.key("required");
  json.begin_array();
  for (const SchemaMember& member : object.members) {
    if (member.presence == SchemaMember::Presence::Always) {
      json.value(member.key);
    }
  }
  json.end_array();
  json.key("properties");
  json.begin_object();
  for (const SchemaMember& member : object.members) {
    json.key(member.key);
    write_type(json, member.description, member.type);
  }
  json.end_object();
}

}  // namespace

std::string schema_reference(std::string_view name) {
  return "\"$ref\": \"#/$defs/" + std::string(name) + '"';
}

std::string schema_enum(const std::vector<std::string_view>& names) {
  JsonWriter json;
  json.array(names);
  return "\"enum\": " + json.drain();
}

void SchemaDefinitions::define(std::string_view name, const SchemaObject& object) {
  json_.key(name);
  json_.begin_object();
  write_schema(json_, object);
  json_.end_object();
}

void SchemaDefinitions::define(std::string_view name, std::string_view description,
                               std::string_view type) {
  json_.key(name);
  write_type(json_, description, type);
}

std::string schema_document(std::string_view id, SchemaObject object,
                            const std::function<void(SchemaDefinitions&)>& define) {
  object.members.insert(object.members.begin(),
                        {"schema", "", R"("const": ")" + std::string(id) + '"'});
  JsonWriter json;
  json.begin_object();
  json.member("$schema", "https://json-schema.org/draft/2020-12/schema");
  json.member("title", id);
  write_schema(json, object);
  json.key("$defs");
  json.begin_object();
  SchemaDefinitions definitions(json);
  define(definitions);
  json.end_object();
  json.end_object();
  return json.take();
}

}  // namespace meshalyzer
