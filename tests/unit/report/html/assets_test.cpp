#include "meshalyzer/report/html/assets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace meshalyzer {
namespace {

using testing::HasSubstr;

/// Reads a file of the source tree.
std::string text_of(const std::string& asset) {
  std::string path = MESHALYZER_MESHES;
  path += "/../lib/meshalyzer/report/html/assets/";
  path += asset;
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The same with the line feed that embedding adds.
std::string line_of(const std::string& asset) {
  std::string text = text_of(asset);
  text += '\n';
  return text;
}

TEST(Assets, AreTheFilesByteForByte) {
  EXPECT_EQ(kPageStyle, line_of("page.css"));
  EXPECT_EQ(kViewMarkup, line_of("view.html"));
  EXPECT_EQ(kThreeLicence, line_of("three_licence.txt"));
}

TEST(Assets, ScriptsFollowEachOther) {
  const std::string script(kViewScript);
  EXPECT_THAT(script, HasSubstr(text_of("data.js")));
  EXPECT_THAT(script, testing::EndsWith(line_of("main.js")));
  EXPECT_THAT(std::string(kIndexScript), HasSubstr(text_of("sort_table.js")));
}

TEST(Assets, ThreeIsWhole) {
  EXPECT_GT(kThree.size(), 500'000U);
  EXPECT_NE(kThree.find("WebGLRenderer"), std::string_view::npos);
  EXPECT_NE(kOrbitControls.find("OrbitControls"), std::string_view::npos);
}

TEST(Assets, NothingOfOursIsFetched) {
  for (const std::string_view asset : {kPageStyle, kViewMarkup, kViewScript, kIndexScript}) {
    EXPECT_EQ(asset.find("http:"), std::string_view::npos);
    EXPECT_EQ(asset.find("https:"), std::string_view::npos);
    EXPECT_EQ(asset.find("@import"), std::string_view::npos);
    EXPECT_EQ(asset.find("fetch("), std::string_view::npos);
  }
}

}  // namespace
}  // namespace meshalyzer
