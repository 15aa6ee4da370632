#include "meshalyzer/report/json/bytes.h"

#include "meshalyzer/report/utf8.h"

#include <utility>

namespace meshalyzer {

void write_bytes(JsonWriter& json, std::string_view name, std::string_view bytes) {
  json.member(name, bytes);
  if (!is_utf8(bytes)) {
    json.member(std::string(name) + "_bytes", latin1_to_utf8(bytes));
  }
}

std::string read_bytes(const JsonNode& object, std::string_view name) {
  const std::optional<JsonNode> node = object.find(std::string(name) + "_bytes");
  if (!node) {
    return std::string(object.member(name).text());
  }
  std::optional<std::string> bytes = utf8_to_latin1(node->text());
  if (!bytes) {
    node->refuse("has a character that is no byte");
  }
  return *std::move(bytes);
}

std::vector<SchemaMember> path_members() {
  return {{"path", "as the user named it; bytes that are not UTF-8 are U+FFFD", schema_type::kText},
          {"path_bytes",
           "only where the path is not UTF-8: its bytes, each as the character of its number",
           schema_type::kText, SchemaMember::Presence::Sometimes}};
}

}  // namespace meshalyzer
