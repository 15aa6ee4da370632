#include "meshalyzer/report/json/curvature.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <vector>

namespace meshalyzer {
namespace {

using nlohmann::json;

json written(const CurvatureStatistics& curvature) {
  JsonWriter writer;
  writer.begin_object();
  write_curvature(writer, curvature);
  writer.end_object();
  return json::parse(writer.take());
}

TEST(WriteCurvature, StatisticsStandUnderTheKeysOfTheContract) {
  std::vector<double> one{1.5}, two{2.5}, three{3.5}, four{4.5};
  CurvatureStatistics curvature;
  curvature.gaussian = summarize(one);
  curvature.mean = summarize(two);
  curvature.k1 = summarize(three);
  curvature.k2 = summarize(four);
  const json object = written(curvature);
  EXPECT_EQ(object["gaussian_curvature"]["min"], 1.5);
  EXPECT_EQ(object["mean_curvature"]["min"], 2.5);
  EXPECT_EQ(object["k1"]["min"], 3.5);
  EXPECT_EQ(object["k2"]["min"], 4.5);
  EXPECT_EQ(object["k2"]["histogram"]["counts"].size(), 16U);
}

TEST(WriteCurvature, AreaDefectAndCountsSayWhatItIsOf) {
  CurvatureStatistics curvature;
  curvature.area = VertexArea::OneRing;
  curvature.total_angle_defect = 12.5;
  curvature.vertices = {1, 2, 3, 4, 5};
  const json expected = {
      {"area", "one-ring"},
      {"total_angle_defect", 12.5},
      {"vertices",
       {{"defined", 1}, {"unused", 2}, {"border", 3}, {"not_one_fan", 4}, {"no_area", 5}}}};
  EXPECT_EQ(written(curvature)["curvature"], expected);
}

}  // namespace
}  // namespace meshalyzer
