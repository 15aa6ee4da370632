#include "meshalyzer/report/json/curvature.h"

#include "meshalyzer/report/json/statistics.h"
#include "meshalyzer/report/json/statistics_reader.h"

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
  const auto statistics = [&](std::string_view name, const Statistics& values) {
    json.key(name);
    write_statistics(json, values);
  };
  statistics("gaussian_curvature", curvature.gaussian);
  statistics("mean_curvature", curvature.mean);
  statistics("k1", curvature.k1);
  statistics("k2", curvature.k2);
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
  curvature.gaussian = read_statistics(object.member("gaussian_curvature"));
  curvature.mean = read_statistics(object.member("mean_curvature"));
  curvature.k1 = read_statistics(object.member("k1"));
  curvature.k2 = read_statistics(object.member("k2"));
  return curvature;
}

}  // namespace meshalyzer
