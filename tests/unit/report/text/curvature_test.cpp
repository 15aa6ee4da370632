#include "meshalyzer/report/text/curvature.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace meshalyzer {
namespace {

std::string text_of(const CurvatureStatistics& curvature) {
  TextLines lines;
  append_curvature(lines, curvature);
  return lines.text();
}

CurvatureStatistics flat_sphere() {
  std::vector<double> ones{1, 1};
  CurvatureStatistics curvature;
  curvature.area = VertexArea::OneRing;
  for (Statistics* quantity :
       {&curvature.gaussian, &curvature.mean, &curvature.k1, &curvature.k2}) {
    *quantity = summarize(ones);
  }
  curvature.total_angle_defect = 12.5;
  return curvature;
}

bool has_line(const std::string& text, const std::string& line) {
  return text.starts_with(line + '\n') || text.find('\n' + line + '\n') != std::string::npos;
}

TEST(AppendCurvature, NamesTheAreaTheDefectAndFourQuantities) {
  const std::string text = text_of(flat_sphere());
  EXPECT_TRUE(has_line(text, "curvature area: one-ring")) << text;
  EXPECT_TRUE(has_line(text, "total angle defect: 12.5")) << text;
  for (const char* name : {"Gaussian curvature", "mean curvature", "principal curvature k1",
                           "principal curvature k2"}) {
    EXPECT_TRUE(has_line(text, std::string(name) + " mean: 1")) << text;
  }
  EXPECT_EQ(text.find("vertices without curvature"), std::string::npos) << text;
}

TEST(AppendCurvature, SaysHowManyVerticesHaveNoneAndWhy) {
  CurvatureStatistics curvature = flat_sphere();
  curvature.vertices = {2, 50, 3, 4, 5};
  const std::string text = text_of(curvature);
  EXPECT_TRUE(has_line(text, "vertices without curvature, on a border: 3")) << text;
  EXPECT_TRUE(has_line(text, "vertices without curvature, not one fan: 4")) << text;
  EXPECT_TRUE(has_line(text, "vertices without curvature, no area: 5")) << text;
}

TEST(AppendCurvature, WithoutAVertexThatHasOneIsUndefined) {
  CurvatureStatistics curvature;
  EXPECT_TRUE(has_line(text_of(curvature),
                       "mean curvature: undefined (no vertex inside a surface that has one)"));
}

}  // namespace
}  // namespace meshalyzer
