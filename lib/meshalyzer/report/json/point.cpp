#include "meshalyzer/report/json/point.h"

namespace meshalyzer {

void write_point(JsonWriter& json, const Vec3& point) {
  json.array(point);
}

Vec3 read_point(const JsonNode& node) {
  JsonElements coordinates = node.elements();
  Vec3 point;
  for (double& coordinate : point) {
    coordinate = coordinates.next().real();
  }
  coordinates.expect_end();
  return point;
}

void define_points(SchemaDefinitions& schema) {
  schema.define("point", "",
                R"("type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3)");
  schema.define("box", {.description = "null where it is of nothing",
                        .members = {{"min", "", schema_reference("point")},
                                    {"max", "", schema_reference("point")}},
                        .null = SchemaObject::Null::Sometimes});
}

}  // namespace meshalyzer
