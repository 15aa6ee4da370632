#include "meshalyzer/report/json/verdict.h"

#include "meshalyzer/report/json/elements.h"

#include <string>
#include <vector>

namespace meshalyzer {

void write_verdict_members(JsonWriter& json, const std::optional<Goodness>& verdict) {
  json.member("good", verdict ? std::optional(verdict->good) : std::nullopt);
  json.key("reasons");
  json.array(verdict ? verdict->reasons : std::vector<std::string>(), JsonLayout::Lines);
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
                            .members = {{"good", "", schema_type::kTruthOrNull},
                                        {"reasons", "", schema_type::kTexts}}});
}

}  // namespace meshalyzer
