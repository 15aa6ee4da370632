#include "meshalyzer/report/json/fields.h"

#include "meshalyzer/report/json/point.h"

namespace meshalyzer {

void write_value(JsonWriter& json, const Box3& box) {
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

void read_value(const JsonNode& object, std::string_view key, Box3& value) {
  const JsonNode node = object.member(key);
  value = node.is_null() ? Box3()
                         : Box3(read_point(node.member("min")), read_point(node.member("max")));
}

void read_value(const JsonNode& object, std::string_view key, bool& value) {
  value = object.member(key).truth();
}

void read_value(const JsonNode& object, std::string_view key, std::size_t& value) {
  value = object.member(key).count();
}

void read_value(const JsonNode& object, std::string_view key, std::int64_t& value) {
  value = object.member(key).integer();
}

void read_value(const JsonNode& object, std::string_view key, double& value) {
  value = read_real(object, key);
}

void read_value(const JsonNode& object, std::string_view key, std::optional<double>& value) {
  value = find_real(object, key);
}

std::string type_of(const bool& /*value*/, Known known) {
  return known == Known::Always ? schema_type::kTruth : schema_type::kTruthOrNull;
}

std::string type_of(const std::size_t& /*value*/, Known known) {
  return known == Known::Always ? schema_type::kCount : schema_type::kCountOrNull;
}

std::string type_of(const std::int64_t& /*value*/, Known known) {
  return known == Known::Always ? schema_type::kInteger : schema_type::kIntegerOrNull;
}

std::string type_of(const double& /*value*/, Known /*known*/) {
  return schema_type::kReal;
}

std::string type_of(const Box3& /*value*/, Known /*known*/) {
  return schema_reference("box");
}

std::string description_of(const FieldInfo& info, Known known) {
  std::string description(info.definition);
  if (known == Known::Measured) {
    description += description.empty() ? "" : "; ";
    description += "null where only the attributes were asked for";
  }
  return description;
}

}  // namespace meshalyzer
