#include "meshalyzer/report/json/name.h"

#include "meshalyzer/report/utf8.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>

namespace meshalyzer {
namespace {

TEST(JsonName, UnicodeNameIsItself) {
  EXPECT_EQ(json_name("caf\xC3\xA9.mesh"), "caf\xC3\xA9.mesh");
  EXPECT_EQ(json_name(""), "");
}

TEST(JsonName, OtherBytesAreSpelt) {
  EXPECT_EQ(json_name("caf\xE9.mesh"),
            "caf\xEF\xBF\xBD"
            "E9.mesh");
}

TEST(JsonName, NameThatLooksLikeASpeltOneIsAnother) {
  EXPECT_NE(json_name("caf\xEF\xBF\xBD"
                      "E9.mesh"),
            json_name("caf\xE9.mesh"));
}

TEST(JsonName, DifferentNamesHaveDifferentUnicodeTexts) {
  // Few kinds of bytes, so that sequences of UTF-8, whole and broken, are frequent.
  constexpr std::string_view kBytes =
      "\xEF\xBF\xBD\xC3\xA9"
      "EBF9D";
  std::mt19937 random(1);
  std::set<std::string> names;
  std::set<std::string> texts;
  for (int i = 0; i < 20000; ++i) {
    std::string name;
    for (std::size_t k = random() % 8; k > 0; --k) {
      name += kBytes[random() % kBytes.size()];
    }
    const std::string text = json_name(name);
    EXPECT_TRUE(is_utf8(text));
    names.insert(name);
    texts.insert(text);
  }
  EXPECT_EQ(names.size(), texts.size());
}

}  // namespace
}  // namespace meshalyzer
