#include "meshalyzer/report/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace meshalyzer {
namespace {

TEST(IsUtf8, WellFormedSequencesOfEveryLengthAre) {
  EXPECT_TRUE(is_utf8(""));
  EXPECT_TRUE(is_utf8("cube.mesh"));
  EXPECT_TRUE(is_utf8("caf\xC3\xA9"));           // U+00E9
  EXPECT_TRUE(is_utf8("\xE2\x82\xAC"));          // U+20AC
  EXPECT_TRUE(is_utf8("\xF0\x9F\x98\x80"));      // U+1F600
  EXPECT_TRUE(is_utf8(std::string("a\0b", 3)));  // U+0000 is a character like any other
}

TEST(IsUtf8, TornOverlongAndSurrogateSequencesAreNot) {
  EXPECT_FALSE(is_utf8("caf\xE9"));
  EXPECT_FALSE(is_utf8("\xE2\x82"));
  EXPECT_FALSE(is_utf8("\xC0\xAF"));          // '/' in two bytes
  EXPECT_FALSE(is_utf8("\xED\xA0\x80"));      // U+D800
  EXPECT_FALSE(is_utf8("\xF4\x90\x80\x80"));  // beyond U+10FFFF
}

TEST(Latin1ToUtf8, EachByteBecomesTheCharacterOfItsNumber) {
  EXPECT_EQ(latin1_to_utf8("a\xE9\x80\xFF"), "a\xC3\xA9\xC2\x80\xC3\xBF");
}

TEST(Utf8ToLatin1, EveryByteComesBack) {
  std::string bytes;
  for (int code = 0; code < 256; ++code) {
    bytes += static_cast<char>(code);
  }
  EXPECT_TRUE(is_utf8(latin1_to_utf8(bytes)));
  EXPECT_EQ(utf8_to_latin1(latin1_to_utf8(bytes)), bytes);
}

TEST(Utf8ToLatin1, WhatIsNoByteGivesNothing) {
  EXPECT_FALSE(utf8_to_latin1("\xC4\x80").has_value());      // U+0100, the first beyond a byte
  EXPECT_FALSE(utf8_to_latin1("\xE2\x82\xAC").has_value());  // U+20AC
  EXPECT_FALSE(utf8_to_latin1("\xE9").has_value());          // no UTF-8
}

}  // namespace
}  // namespace meshalyzer
