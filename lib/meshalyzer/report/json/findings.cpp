#include "meshalyzer/report/json/findings.h"

#include "meshalyzer/report/json/name.h"
#include "meshalyzer/report/json/non_finite.h"
#include "meshalyzer/report/json/point.h"

#include <cmath>

namespace meshalyzer {
namespace {

void write_reals(JsonWriter& json, double distance, const Vec3& point) {
  json.begin_object(JsonLayout::Row);
  json.member("distance", distance);
  json.member("x", point.x());
  json.member("y", point.y());
  json.member("z", point.z());
  write_non_finite(json,
                   {{"distance", distance}, {"x", point.x()}, {"y", point.y()}, {"z", point.z()}});
  json.end_object();
}

}  // namespace

void FindingsWriter::pairs(std::span<const SetPair> pairs) {
  json_.begin_array();
  for (const SetPair& pair : pairs) {
    json_.begin_array(JsonLayout::Row);
    name(pair.mesh_a);
    json_.value(pair.face_a);
    name(pair.mesh_b);
    json_.value(pair.face_b);
    json_.value(contact_name(pair.kind));
    end_row();
  }
  json_.end_array();
}

void FindingsWriter::bounds(const SetIntersections& found) {
  if (found.is_search_stopped) json_.member("at_least", true);
  if (found.unlisted.empty()) return;
  json_.key("unlisted");
  json_.begin_array();
  for (const MeshMeeting& meeting : found.unlisted) {
    json_.begin_array(JsonLayout::Row);
    name(meeting.mesh_a);
    name(meeting.mesh_b);
    for (const ContactKind kind : kContactKinds) json_.value(meeting.pairs.of(kind));
    end_row();
  }
  json_.end_array();
}

void FindingsWriter::contained(std::span<const ContainedMesh> meshes) {
  json_.begin_array();
  for (const ContainedMesh& mesh : meshes) {
    json_.begin_array(JsonLayout::Row);
    name(mesh.inner);
    name(mesh.outer);
    end_row();
  }
  json_.end_array();
}

void FindingsWriter::closest(const ObjectSeparation& separation) {
  json_.begin_array();
  for (std::size_t i = 0; i < separation.vertices.size(); ++i) {
    json_.begin_array(JsonLayout::Row);
    closest_row(separation, i);
    end_row();
  }
  json_.end_array();
}

void FindingsWriter::closest_row(const ObjectSeparation& separation, std::size_t i) {
  json_.value(separation.vertices[i]);
  if (separation.objects[i] == kNoIndex) {
    for (int column = 1; column < 5; ++column) {
      json_.null();
    }
    return;
  }
  const double distance = separation.distances[i];
  const Vec3& point = separation.points[i];
  json_.value(distance);
  name(separation.objects[i]);
  json_.value(separation.faces[i]);
  write_point(json_, point);
  if (!std::isfinite(distance) || !point.allFinite()) {
    write_reals(json_, distance, point);
  }
}

void FindingsWriter::name(Index mesh) {
  json_.value(json_name(names_[mesh]));
}

void FindingsWriter::end_row() {
  json_.end_array();
  on_row_();
}

void define_findings(SchemaDefinitions& schema) {
  schema.define("name",
                "of a mesh in its set: that of its file where these differ, else its path; bytes "
                "that are not UTF-8 are U+FFFD and two hexadecimal digits",
                schema_type::kText);
  schema.define("set_pairs",
                "between meshes: name, face id, name, face id, kind; null where not asked for",
                R"("type": ["array", "null"], "items": {"type": "array", "minItems": 5, )"
                R"("maxItems": 5, "prefixItems": [{"$ref": "#/$defs/name"}, {"type": "integer"}, )"
                R"({"$ref": "#/$defs/name"}, {"type": "integer"}, {"$ref": "#/$defs/contact"}]})");
  schema.define("contained", "inner mesh, outer mesh; null where not asked for",
                R"("type": ["array", "null"], "items": {"type": "array", "minItems": 2, )"
                R"("maxItems": 2, "items": {"$ref": "#/$defs/name"}})");
  schema.define("closest",
                "vertex id, distance (negative where it lies inside another mesh), name, face id, "
                "point; all but the first null where nothing was found. Where a real is not finite "
                "a sixth element tells which",
                R"("type": "array", "minItems": 5, "maxItems": 6, "prefixItems": [)"
                R"({"type": "integer"}, {"type": ["number", "null"]}, )"
                R"({"type": ["string", "null"]}, {"type": ["integer", "null"]}, )"
                R"({"type": ["array", "null"], "items": {"type": ["number", "null"]}, )"
                R"("minItems": 3, "maxItems": 3}, {"$ref": "#/$defs/closest_reals"}])");
  schema.define("closest_reals", {.description = "the reals of a row that are not all finite",
                                  .members = {{"distance", "", schema_type::kReal},
                                              {"x", "", schema_type::kReal},
                                              {"y", "", schema_type::kReal},
                                              {"z", "", schema_type::kReal},
                                              {"non_finite", "", schema_reference("non_finite")}}});
}

}  // namespace meshalyzer
