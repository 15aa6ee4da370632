#include "field_sample.h"
#include "meshalyzer/io/field_formats.h"
#include "meshalyzer/io/obj.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace meshalyzer {
namespace {

std::string obj_of(const FieldSample& sample = {}) {
  return sample.print(FieldFormat::Obj);
}

/// The lines that begin with a word, without it.
std::vector<std::string> lines_of(const std::string& text, const std::string& word) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(word + ' ', 0) == 0) {
      lines.push_back(line.substr(word.size() + 1));
    }
  }
  return lines;
}

TEST(PrintObjField, OurReaderReadsTheMeshBack) {
  for (const FieldSample& sample : {FieldSample(), face_field_sample()}) {
    const Soup soup = parse_obj(obj_of(sample), "field.obj");
    EXPECT_EQ(soup.positions, sample.positions);
    EXPECT_EQ(soup.triangles, sample.triangles);
  }
}

TEST(PrintObjField, ValuesAreTheFirstTextureCoordinates) {
  const std::vector<std::string> values = lines_of(obj_of(), "vt");
  ASSERT_EQ(values.size(), 4U);
  EXPECT_EQ(values[0], "0.1 0");
  EXPECT_EQ(values[1], "-2 0");
  EXPECT_EQ(values[2], "1e-300 0");
}

TEST(PrintObjField, FaceOfVerticesWithValuesNamesThem) {
  EXPECT_EQ(lines_of(obj_of(), "f")[0], "1/1 2/2 3/3");
}

TEST(PrintObjField, VertexWithoutAFiniteValueIsNoTexturePointOfAnyFace) {
  for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    FieldSample sample;
    sample.values[3] = value;
    EXPECT_EQ(lines_of(obj_of(sample), "vt")[3], "0 0");
    EXPECT_EQ(lines_of(obj_of(sample), "f")[1], "4 2 1");
  }
}

TEST(PrintObjField, ColoursFollowTheCoordinates) {
  FieldSample sample;
  sample.positions[1] = {1.5, -2, 1e-7};
  sample.colours[1] = {0, 51, 255};
  EXPECT_EQ(lines_of(obj_of(sample), "v")[1], "1.5 -2 1e-07 0 0.2 1");
}

TEST(PrintObjField, EveryStepOfAColourComesBackWhetherRoundedOrCutOff) {
  FieldSample sample;
  for (int step = 0; step < 256; ++step) {
    sample.colours[0].green = static_cast<std::uint8_t>(step);
    std::istringstream in(lines_of(obj_of(sample), "v")[0]);
    double x = 0, y = 0, z = 0, red = 0, green = 0;
    in >> x >> y >> z >> red >> green;
    EXPECT_LE(green, 1.0);
    EXPECT_EQ(std::lround(255 * green), step);
    EXPECT_EQ(static_cast<int>(255 * static_cast<float>(green)), step);
  }
}

TEST(PrintObjField, CommentsStandFirst) {
  FieldSample sample;
  sample.comments = {"one", "two words"};
  EXPECT_EQ(obj_of(sample).rfind("# one\n# two words\n", 0), 0U);
}

TEST(PrintObjField, MeshOfNothingHasOnlyComments) {
  const Soup soup = parse_obj(print_obj_field({}), "field.obj");
  EXPECT_EQ(soup.n_vertices(), 0U);
  EXPECT_EQ(soup.n_faces(), 0U);
}

}  // namespace
}  // namespace meshalyzer
