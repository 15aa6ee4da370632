#include "meshalyzer/report/json/non_finite.h"

#include "meshalyzer/base/numbers.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer {
namespace {

double read_non_finite(const JsonNode& node) {
  const std::optional<double> value = parse_real(node.text());
  if (!value || std::isfinite(*value)) {
    node.refuse("neither infinite nor NaN");
  }
  return *value;
}

}  // namespace

void write_non_finite(JsonWriter& json, std::span<const NamedReal> reals) {
  const auto is_finite = [](const NamedReal& real) { return std::isfinite(real.value); };
  if (std::all_of(reals.begin(), reals.end(), is_finite)) {
    return;
  }
  json.key("non_finite");
  json.begin_object(JsonLayout::Row);
  for (const NamedReal& real : reals) {
    if (!is_finite(real)) {
      json.member(real.name, shortest(real.value));
    }
  }
  json.end_object();
}

std::optional<double> find_real(const JsonNode& object, std::string_view name) {
  if (const JsonNode node = object.member(name); !node.is_null()) {
    return node.real();
  }
  if (const std::optional<JsonNode> others = object.find("non_finite")) {
    if (const std::optional<JsonNode> node = others->find(name)) {
      return read_non_finite(*node);
    }
  }
  return std::nullopt;
}

double read_real(const JsonNode& object, std::string_view name) {
  const std::optional<double> value = find_real(object, name);
  if (!value) {
    object.member(name).refuse("no value");
  }
  return *value;
}

void define_non_finite(SchemaDefinitions& schema) {
  schema.define(
      "non_finite",
      "only where some real beside it is infinite or NaN, and so null: its key -> which",
      R"("type": "object", "additionalProperties": {"enum": ["inf", "-inf", "nan", "-nan"]})");
}

SchemaMember non_finite_member() {
  return {.key = "non_finite",
          .description = "",
          .type = schema_reference("non_finite"),
          .presence = SchemaMember::Presence::Sometimes};
}

}  // namespace meshalyzer
