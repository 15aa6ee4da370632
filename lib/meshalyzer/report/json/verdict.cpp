#include "meshalyzer/report/json/verdict.h"

#include "meshalyzer/report/json/elements.h"

#include <string>
#include <string_view>

namespace meshalyzer {

void write_verdict_members(JsonWriter& json, const std::optional<Goodness>& verdict) {
  json.member("good", verdict ? std::optional(verdict->good) : std::nullopt);
  json.key("reasons");
  json.begin_array();
  if (verdict) {
    for (const std::string& reason : verdict->reasons) {
      json.value(std::string_view(reason));
    }
  }
  json.end_array();
}

void write_verdict(JsonWriter& json, const std::optional<Goodness>& verdict) {
  json.key("verdict");
  json.begin_object();
  write_verdict_members(json, verdict);
  json.end_object();
}

std::optional<Goodness> read_verdict_members(const JsonNode& object) {
  const JsonNode good = object.member("good");
  if (good.is_null()) {
    return std::nullopt;
  }
  Goodness verdict{good.truth(), {}};
  for (JsonElements reasons = object.member("reasons").elements(); !reasons.at_end();) {
    verdict.reasons.emplace_back(reasons.next().text());
  }
  return verdict;
}

void define_verdict(SchemaDefinitions& schema) {
  schema.define("verdict", {.description = "",
                            .members = {{"good", "", std::string(schema_type::kTruthOrNull)},
                                        {"reasons", "", std::string(schema_type::kTexts)}}});
}

}  // namespace meshalyzer
