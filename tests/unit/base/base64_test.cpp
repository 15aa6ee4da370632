#include "meshalyzer/base/base64.h"

#include <gtest/gtest.h>

#include <string>

namespace meshalyzer {
namespace {

std::string base64(std::string_view bytes) {
  std::string text;
  append_base64(text, bytes);
  return text;
}

TEST(AppendBase64, WritesTheVectorsOfTheStandard) {
  // RFC 4648, section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(AppendBase64, BytesAreNotSigned) {
  // 11111111 11110000 00000000 is 63 63 0 0; 11111011 11101111 10111110 is 62 62 62 62.
  EXPECT_EQ(base64(std::string("\xFF\xF0\x00", 3)), "//AA");
  EXPECT_EQ(base64("\xFB\xEF\xBE"), "++++");
}

TEST(AppendBase64, KeepsWhatIsThere) {
  std::string text = "data:";
  append_base64(text, "foo");
  append_base64(text, "f");
  EXPECT_EQ(text, "data:Zm9vZg==");
}

}  // namespace
}  // namespace meshalyzer
