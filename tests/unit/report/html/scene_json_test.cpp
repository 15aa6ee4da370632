#include "meshalyzer/report/html/scene_json.h"

#include "html/sample_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <bit>
#include <limits>
#include <set>

namespace meshalyzer {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<std::uint8_t> decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int n_bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<std::uint32_t>(digits.find(c));
    n_bits += 6;
    if (n_bits < 8) continue;
    n_bits -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> static_cast<unsigned>(n_bits)));
  }
  return bytes;
}

template <typename Number>
std::vector<Number> numbers_of(const json& text) {
  const std::vector<std::uint8_t> bytes = decoded(text.get<std::string>());
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 4; ++k) bits |= std::uint32_t{bytes[4 * i + k]} << (8 * k);
    numbers[i] = std::bit_cast<Number>(bits);
  }
  return numbers;
}

std::string text_of(const Scene& scene, std::string_view title = "") {
  const MeshName name = sample_name();
  const DefectReport defects = sample_defects();
  const PageMesh mesh{name, defects, scene};
  const std::array meshes{TitledMesh{title, mesh}};
  std::string html;
  append_scene_json(html, meshes);
  return html;
}

json first_scene(const Scene& scene) {
  return json::parse(text_of(scene)).at("scenes").at(0);
}

TEST(AppendSceneJson, ArraysAreThoseOfTheScene) {
  const Scene scene = sample_scene();
  const json detail = first_scene(scene).at("detail");
  EXPECT_EQ(numbers_of<float>(detail.at("positions")), scene.detail.positions);
  EXPECT_EQ(numbers_of<std::uint32_t>(detail.at("triangles")), scene.detail.triangles);
}

TEST(AppendSceneJson, NormalsAreBytesOfWhichTheLargestIsOne) {
  Scene scene = sample_scene();
  // 127 * 0.6 is 76.2, 127 * 0.8 is 101.6; -102 is 154 of an unsigned byte.
  scene.detail.normals = {0.0F, 0.6F, -0.8F, 1.0F, -1.0F, 0.0F};
  EXPECT_THAT(decoded(first_scene(scene).at("detail").at("normals").get<std::string>()),
              ElementsAre(0, 76, 154, 127, 129, 0));
}

TEST(AppendSceneJson, OneValueStandsForManyThatAreTheSame) {
  Scene scene = sample_scene();
  scene.fields[0].detail = {2.0F, 2.0F, 2.0F, 2.0F};
  EXPECT_THAT(numbers_of<float>(first_scene(scene).at("fields").at(0).at("detail")),
              ElementsAre(2.0F));
  scene.fields[0].detail.assign(4, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(numbers_of<float>(first_scene(scene).at("fields").at(0).at("detail")).size(), 1U);
  scene.fields[0].detail = {0.0F, 0.0F, 0.0F, 1.0F};
  EXPECT_EQ(numbers_of<float>(first_scene(scene).at("fields").at(0).at("detail")).size(), 4U);
}

TEST(AppendSceneJson, RecordsAreNamedByTheIdsOfTheFile) {
  const json detail = first_scene(sample_scene()).at("detail");
  EXPECT_THAT(numbers_of<std::int32_t>(detail.at("vertex_ids")), ElementsAre(10, 20, 30, 40));
  EXPECT_THAT(numbers_of<std::int32_t>(detail.at("face_ids")), ElementsAre(7, 9));
}

TEST(AppendSceneJson, PlaceAndSizeAreTold) {
  const json scene = first_scene(sample_scene());
  EXPECT_EQ(scene.at("centre"), json({10.0, 20.0, 30.5}));
  EXPECT_EQ(scene.at("radius"), 2.5);
  EXPECT_EQ(scene.at("scale"), 1.0);
  EXPECT_EQ(scene.at("faces"), 2);
  EXPECT_EQ(scene.at("decimated"), 0);
  EXPECT_TRUE(scene.at("context").is_null());
}

TEST(AppendSceneJson, FieldHasItsValuesItsScaleAndItsRange) {
  const json field = first_scene(sample_scene()).at("fields").at(0);
  EXPECT_EQ(field.at("name"), "mean");
  EXPECT_EQ(field.at("label"), std::string(field_label(FieldName::Mean)));
  EXPECT_EQ(field.at("place"), "vertices");
  EXPECT_EQ(field.at("kind"), "signed");
  EXPECT_EQ(field.at("palette"), "diverging");
  EXPECT_EQ(field.at("scale"), json({-1.0, 1.0}));
  EXPECT_EQ(field.at("range"), json({-1.5, 2.0}));
  EXPECT_TRUE(field.at("context").is_null());
  const std::vector<float> values = numbers_of<float>(field.at("detail"));
  ASSERT_EQ(values.size(), 4U);
  EXPECT_EQ(values[0], -1.5F);
  EXPECT_TRUE(values[1] != values[1]);
  EXPECT_EQ(values[3], 2.0F);
}

TEST(AppendSceneJson, ContextIsDrawnWhereThereIsOne) {
  Scene scene = sample_scene();
  scene.context = scene.detail;
  scene.fields[0].context = {5.0F, 6.0F, 7.0F, 8.0F};
  scene.n_decimated = 99;
  const json parsed = first_scene(scene);
  EXPECT_EQ(numbers_of<float>(parsed.at("context").at("positions")), scene.context.positions);
  EXPECT_THAT(numbers_of<float>(parsed.at("fields").at(0).at("context")),
              ElementsAre(5.0F, 6.0F, 7.0F, 8.0F));
  EXPECT_EQ(parsed.at("decimated"), 99);
}

TEST(AppendSceneJson, HighlightTellsItsDefectAndWhereItIs) {
  const json highlight = first_scene(sample_scene()).at("highlights").at(0);
  EXPECT_EQ(highlight.at("code"), "hole");
  EXPECT_EQ(highlight.at("text"), "edge 10-20");
  EXPECT_THAT(numbers_of<std::uint32_t>(highlight.at("faces")), ElementsAre(1U));
  EXPECT_THAT(numbers_of<float>(highlight.at("points")), ElementsAre(0.5F, 0.5F, 0.5F));
  EXPECT_EQ(numbers_of<float>(highlight.at("segments")).size(), 6U);
  EXPECT_EQ(highlight.at("focus"), json({0.25, 0.5, 0.75}));
  EXPECT_EQ(highlight.at("radius"), 0.5);
  EXPECT_EQ(highlight.at("cut"), true);
}

TEST(AppendSceneJson, LinesOfEachKindAreThere) {
  const json lines = first_scene(sample_scene()).at("lines");
  EXPECT_THAT(numbers_of<float>(lines.at("borders")),
              ElementsAre(0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F));
  EXPECT_EQ(lines.at("non_manifold_edges"), "");
  EXPECT_EQ(lines.at("flipped_edges"), "");
  EXPECT_EQ(lines.at("intersections"), "");
}

TEST(AppendSceneJson, PalettesAreSampledFromEndToEnd) {
  const json palettes = json::parse(text_of(sample_scene())).at("palettes");
  for (const Palette palette : all_palettes()) {
    const auto bytes = decoded(palettes.at(std::string(palette_name(palette))));
    ASSERT_EQ(bytes.size(), 768U);
    const Colour first = colour_of(palette, 0.0);
    const Colour last = colour_of(palette, 1.0);
    EXPECT_THAT(std::vector(bytes.begin(), bytes.begin() + 3),
                ElementsAre(first.red, first.green, first.blue));
    EXPECT_THAT(std::vector(bytes.end() - 3, bytes.end()),
                ElementsAre(last.red, last.green, last.blue));
  }
  const auto categories = decoded(palettes.at("category"));
  ASSERT_EQ(categories.size(), 768U);
  EXPECT_EQ(categories[3 * 7 + 1], category_colour(7).green);
}

TEST(AppendSceneJson, EachCodeHasAColourOfItsOwn) {
  const json codes = json::parse(text_of(sample_scene())).at("codes");
  ASSERT_EQ(codes.size(), kDefectCodes);
  std::set<std::string> colours;
  for (std::size_t i = 0; i < kDefectCodes; ++i) {
    EXPECT_EQ(codes[i].at("code"), std::string(defect_name(all_defect_codes()[i])));
    const auto colour = codes[i].at("colour").get<std::string>();
    EXPECT_THAT(colour, testing::MatchesRegex("#[0-9a-f]{6}"));
    colours.insert(colour);
  }
  EXPECT_EQ(colours.size(), kDefectCodes);
}

TEST(AppendSceneJson, TextCannotEndTheElement) {
  Scene scene = sample_scene();
  const std::string note = "</script><!-- \xE2\x80\xA8 \xE2\x80\xA9 \xE2\x82\xAC";
  scene.notes = {note};
  const std::string text = text_of(scene);
  EXPECT_THAT(text, Not(HasSubstr("<")));
  EXPECT_THAT(text, Not(HasSubstr("\xE2\x80\xA8")));
  EXPECT_THAT(text, Not(HasSubstr("\xE2\x80\xA9")));
  EXPECT_EQ(json::parse(text).at("scenes").at(0).at("notes").at(0), note);
}

TEST(AppendSceneJson, ScenesStandInTheirOrderWithTheirTitles) {
  const MeshName name = sample_name();
  const DefectReport defects = sample_defects();
  const Scene scene = sample_scene();
  const PageMesh mesh{name, defects, scene};
  const std::array meshes{TitledMesh{"before", mesh}, TitledMesh{"after", mesh}};
  std::string html;
  append_scene_json(html, meshes);
  const json scenes = json::parse(html).at("scenes");
  ASSERT_EQ(scenes.size(), 2U);
  EXPECT_EQ(scenes[0].at("title"), "before");
  EXPECT_EQ(scenes[1].at("title"), "after");
}

TEST(AppendSceneJson, EmptySceneIsValid) {
  const Scene scene;
  const json parsed = first_scene(scene);
  EXPECT_EQ(parsed.at("detail").at("positions"), "");
  EXPECT_TRUE(parsed.at("fields").empty());
}

TEST(ListedDefectText, DefectWithNothingToSayHasTheNameOfItsCode) {
  Defect defect;
  defect.code = DefectCode::Corrupt;
  EXPECT_EQ(listed_defect_text(defect, sample_name()), "corrupt");
}

}  // namespace
}  // namespace meshalyzer
