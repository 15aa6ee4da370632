#include "meshalyzer/report/json/curvature.h"

#include "meshalyzer/report/json/non_finite.h"
#include "meshalyzer/report/json/statistics.h"

#include <array>
#include <string_view>

namespace meshalyzer {
namespace {

/// By CurvatureState.
constexpr std::array<std::string_view, kCurvatureStates> kStateNames{"defined", "unused", "border",
                                                                     "not_one_fan", "no_area"};

VertexArea read_area(const JsonNode& node) {
  const std::optional<VertexArea> area = vertex_area(node.text());
  if (!area) {
    node.refuse("no area of curvatures");
  }
  return *area;
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
    json.member(kStateNames[i], curvature.vertices[i]);
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
    curvature.vertices[i] = vertices.member(kStateNames[i]).count();
  }
  for (const auto& [quantity, member] : kCurvatures) {
    curvature.*member = read_statistics(object.member(quantity.info.key));
  }
  return curvature;
}

}  // namespace meshalyzer
