#include "meshalyzer/report/json/curvature.h"

#include "meshalyzer/report/json/non_finite.h"
#include "meshalyzer/report/json/statistics.h"

#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace meshalyzer {
namespace {

/// The keys of the counts of vertices, by CurvatureState.
constexpr std::array<FieldInfo, kCurvatureStates> kStates{
    {{.key = "defined"},
     {.key = "unused", .definition = "no face uses the vertex"},
     {.key = "border"},
     {.key = "not_one_fan", .definition = "non-manifold, pinched, or the end of a flipped edge"},
     {.key = "no_area"}}};

VertexArea read_area(const JsonNode& node) {
  const std::optional<VertexArea> area = vertex_area(node.text());
  if (!area) {
    node.refuse("no area of curvatures");
  }
  return *area;
}

std::string area_type() {
  return schema_enum({area_name(VertexArea::Mixed), area_name(VertexArea::Voronoi),
                      area_name(VertexArea::Barycentric), area_name(VertexArea::OneRing)});
}

}  // namespace

void write_curvature(JsonWriter& json, const CurvatureStatistics& curvature) {
  for (const auto& [quantity, member] : kCurvatures) {
    json.key(quantity.info.key);
    write_statistics(json, curvature.*member);
  }
  json.key("curvature");
  json.begin_object();
  json.member("area", area_name(curvature.area));
  json.member("total_angle_defect", curvature.total_angle_defect);
  json.key("vertices");
  json.begin_object(JsonLayout::Row);
  for (std::size_t i = 0; i < kCurvatureStates; ++i) {
    json.member(kStates[i].key, curvature.vertices[i]);
  }
  json.end_object();
  json.end_object();
}

std::optional<CurvatureStatistics> read_curvature(const JsonNode& object) {
  const std::optional<JsonNode> node = object.find("curvature");
  if (!node) {
    return std::nullopt;
  }
  CurvatureStatistics curvature;
  curvature.area = read_area(node->member("area"));
  curvature.total_angle_defect = read_real(*node, "total_angle_defect");
  const JsonNode vertices = node->member("vertices");
  for (std::size_t i = 0; i < kCurvatureStates; ++i) {
    curvature.vertices[i] = vertices.member(kStates[i].key).count();
  }
  for (const auto& [quantity, member] : kCurvatures) {
    curvature.*member = read_statistics(object.member(quantity.info.key));
  }
  return curvature;
}

void define_curvature(SchemaDefinitions& schema) {
  std::vector<SchemaMember> states;
  for (const FieldInfo& state : kStates) {
    states.push_back({std::string(state.key), std::string(state.definition), schema_type::kCount});
  }
  schema.define("curvature_vertices",
                {.description = "how many vertices have a curvature, or none and why",
                 .members = std::move(states),
                 .others = SchemaObject::Others::Forbidden});
  schema.define("curvature",
                {.description = "what the statistics of the curvatures are of",
                 .members = {{"area", "what the curvatures are spread over", area_type()},
                             {"total_angle_defect", "radians: 2 pi (V - E + F), to rounding",
                              schema_type::kReal},
                             {"vertices", "", schema_reference("curvature_vertices")},
                             non_finite_member()},
                 .others = SchemaObject::Others::Forbidden});
}

void append_curvature_members(std::vector<SchemaMember>& members) {
  for (const auto& [quantity, member] : kCurvatures) {
    SchemaMember& row = members.emplace_back(statistics_member(quantity));
    row.description += "; where curvature was asked for";
    row.presence = SchemaMember::Presence::Sometimes;
  }
  members.push_back({.key = "curvature",
                     .description = "where curvature was asked for",
                     .type = schema_reference("curvature"),
                     .presence = SchemaMember::Presence::Sometimes});
}

}  // namespace meshalyzer
