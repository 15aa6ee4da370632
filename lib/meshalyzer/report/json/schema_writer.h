#pragma once

#include "meshalyzer/report/json/writer.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The types of values in JSON Schema: keywords of an object, in JSON. They are C strings, which
/// convert to the texts of SchemaMember.
namespace schema_type {
inline constexpr const char* kText = R"("type": "string")";
inline constexpr const char* kTexts = R"("type": "array", "items": {"type": "string"})";
inline constexpr const char* kTextByKey =
    R"("type": "object", "additionalProperties": {"type": "string"})";
inline constexpr const char* kTruth = R"("type": "boolean")";
inline constexpr const char* kTruthOrNull = R"("type": ["boolean", "null"])";
inline constexpr const char* kInteger = R"("type": "integer")";
inline constexpr const char* kIntegerOrNull = R"("type": ["integer", "null"])";
inline constexpr const char* kCount = R"("type": "integer", "minimum": 0)";
inline constexpr const char* kCountOrNull = R"("type": ["integer", "null"], "minimum": 0)";
/// A real, which is null if it is infinite.
inline constexpr const char* kReal = R"("type": ["number", "null"])";
}  // namespace schema_type

/// Returns the schema that refers to a definition by its name: `"$ref": "#/$defs/box"`.
[[nodiscard]] std::string schema_reference(std::string_view name);

/// Returns the schema of a text that is one of a few: `"enum": ["yes", "no"]`.
[[nodiscard]] std::string schema_enum(const std::vector<std::string_view>& names);

/// A member of an object.
struct SchemaMember {
  std::string key;
  /// The description; empty if the key is clear.
  std::string description;
  /// The keywords of its type: see schema_type.
  std::string type;
  enum class Presence { Always, Sometimes };
  Presence presence = Presence::Always;
};

/// The schema of an object: its members.
struct SchemaObject {
  std::string description;
  std::vector<SchemaMember> members = {};
  enum class Null { Never, Sometimes };
  Null null = Null::Never;
  /// Tells whether it may have further members, so that more may be added later.
  enum class Others { Allowed, Forbidden };
  Others others = Others::Allowed;
};

/// Writes the definitions of a schema, "$defs".
class SchemaDefinitions {
 public:
  /// @param json  The writer, which has begun an object; the class only refers to it.
  explicit SchemaDefinitions(JsonWriter& json) : json_(json) {}

  void define(std::string_view name, const SchemaObject& object);
  /// @param type  The keywords of the type: see schema_type.
  void define(std::string_view name, std::string_view description, std::string_view type);

 private:
  JsonWriter& json_;
};

/// Returns a whole schema.
/// @param id      The value of "schema" in the reports that it describes.
/// @param object  The schema of a report; its member "schema" is added as the first.
/// @param define  Writes the definitions that it refers to.
[[nodiscard]] std::string schema_document(std::string_view id, SchemaObject object,
                                          const std::function<void(SchemaDefinitions&)>& define);

}  // namespace meshalyzer
