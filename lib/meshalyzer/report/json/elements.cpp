#include "meshalyzer/report/json/elements.h"

#include "meshalyzer/base/find_named.h"
#include "meshalyzer/report/json/record_ids.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>

namespace meshalyzer {

Index read_id(const JsonNode& node) {
  const std::int64_t id = node.integer();
  if (id < std::numeric_limits<std::int32_t>::min() ||
      id > std::numeric_limits<std::int32_t>::max()) {
    node.refuse("no id: beyond 32 bits");
  }
  return id_in_place_of_record(static_cast<std::int32_t>(id));
}

ContactKind read_contact(const JsonNode& node) {
  const std::optional<ContactKind> kind = find_named(kContactKinds, node.text(), contact_name);
  if (!kind) {
    node.refuse("no kind of contact");
  }
  return *kind;
}

void write_numbering(JsonWriter& json, const NumberingBreak& place) {
  json.begin_object(JsonLayout::Row);
  json.key("ids");
  json.array(place.ids);
  json.member("offender", place.offender);
  json.end_object();
}

NumberingBreak read_numbering(const JsonNode& object) {
  NumberingBreak place;
  for (JsonElements ids = object.member("ids").elements(); !ids.at_end();) {
    place.ids.push_back(ids.next().integer());
  }
  place.offender = object.member("offender").count();
  return place;
}

void define_elements(SchemaDefinitions& schema) {
  schema.define("ids", "", R"("type": "array", "items": {"type": "integer"})");
  std::vector<std::string_view> names;
  std::transform(kContactKinds.begin(), kContactKinds.end(), std::back_inserter(names),
                 contact_name);
  schema.define("contact", "how two faces meet", schema_enum(names));
  schema.define(
      "numbering",
      {.description = "up to five ids in file order, and which of them is the first that "
                      "does not count on",
       .members = {{"ids", "", schema_reference("ids")}, {"offender", "", schema_type::kCount}},
       .null = SchemaObject::Null::Sometimes});
}

}  // namespace meshalyzer
