#include "meshalyzer/report/json/writer.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace meshalyzer {
namespace {

std::string written(const auto& value) {
  JsonWriter writer;
  writer.value(value);
  return writer.take();
}

std::string written_text(std::string_view text) {
  return written(text);
}

TEST(JsonWriter, RealsAreShortestTextThatReadsBack) {
  // One that Grisu2 prints with 17 digits: 170.59224598930481.
  EXPECT_EQ(written(170.5922459893048), "170.5922459893048\n");
  const double third = 1.0 / 3.0;
  EXPECT_EQ(nlohmann::json::parse(written(third)).get<double>(), third);
  EXPECT_EQ(written(0.1), "0.1\n");
  EXPECT_EQ(written(6.0), "6\n");
}

TEST(JsonWriter, WhatIsNotFiniteIsNull) {
  EXPECT_EQ(written(std::numeric_limits<double>::infinity()), "null\n");
  EXPECT_EQ(written(std::numeric_limits<double>::quiet_NaN()), "null\n");
}

TEST(JsonWriter, AbsentValuesAreNullAndPresentOnesThemselves) {
  EXPECT_EQ(written(std::optional<bool>()), "null\n");
  EXPECT_EQ(written(std::optional<bool>(false)), "false\n");
  EXPECT_EQ(written(std::optional<std::int64_t>(-3)), "-3\n");
}

TEST(JsonWriter, QuotesBackslashesAndControlsAreEscaped) {
  EXPECT_EQ(written_text("a\"b\\c\nd\te\x01"
                         "f\x1f"),
            "\"a\\\"b\\\\c\\nd\\te\\u0001f\\u001f\"\n");
}

TEST(JsonWriter, ValidUnicodeIsKept) {
  // One character each of two, three and four bytes.
  EXPECT_EQ(written_text("\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80"),
            "\"\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80\"\n");
}

TEST(JsonWriter, BytesThatAreNotUnicodeBecomeReplacementCharacters) {
  const std::string replaced = "\xEF\xBF\xBD";
  EXPECT_EQ(written_text("a\xFFz"), "\"a" + replaced + "z\"\n");
  // A sequence cut short by the end.
  EXPECT_EQ(written_text("\xC3"), "\"" + replaced + "\"\n");
  // Overlong '/', a surrogate, and what lies beyond U+10FFFF.
  EXPECT_EQ(written_text("\xC0\xAF"), "\"" + replaced + replaced + "\"\n");
  EXPECT_EQ(written_text("\xED\xA0\x80"), "\"" + replaced + replaced + replaced + "\"\n");
  EXPECT_EQ(written_text("\xF4\x90\x80\x80"),
            "\"" + replaced + replaced + replaced + replaced + "\"\n");
}

TEST(JsonWriter, LinesAreIndentedAndRowsStayOnOneLine) {
  JsonWriter writer;
  writer.begin_object();
  writer.member("n", 1);
  writer.key("row");
  writer.begin_array(JsonLayout::Row);
  writer.value(1);
  writer.value(true);
  writer.begin_array(JsonLayout::Row);
  writer.end_array();
  writer.end_array();
  writer.key("none");
  writer.begin_array();
  writer.end_array();
  writer.end_object();
  EXPECT_EQ(writer.take(), "{\n \"n\": 1,\n \"row\": [1, true, []],\n \"none\": []\n}\n");
}

TEST(JsonWriter, WhatIsNestedInARowIsOnItsLineToo) {
  JsonWriter writer;
  writer.begin_object(JsonLayout::Row);
  writer.key("list");
  writer.begin_array();
  writer.begin_object(JsonLayout::Lines);
  writer.member("n", 1);
  writer.end_object();
  writer.value(2);
  writer.end_array();
  writer.member("last", true);
  writer.end_object();
  EXPECT_EQ(writer.take(), "{\"list\": [{\"n\": 1}, 2], \"last\": true}\n");
}

/// Writes an object with something of everything, and calls `between` after each step.
template <typename Between>
std::string written_in_steps(Between&& between) {
  JsonWriter writer;
  std::string text;
  const auto step = [&] { text += between(writer); };
  writer.begin_object();
  step();
  writer.key("lines");
  step();
  writer.begin_array();
  step();
  writer.value(1.5);
  step();
  writer.value(std::string_view("two"));
  step();
  writer.end_array();
  step();
  writer.key("row");
  writer.begin_object(JsonLayout::Row);
  step();
  writer.member("a", 1);
  step();
  writer.member("b", 2);
  writer.end_object();
  step();
  writer.end_object();
  step();
  return text + writer.take();
}

TEST(JsonWriter, DrainedAnywhereGivesTheSameText) {
  const std::string whole = written_in_steps([](JsonWriter&) { return std::string(); });
  const std::string drained = written_in_steps([](JsonWriter& writer) { return writer.drain(); });
  EXPECT_EQ(drained, whole);
  EXPECT_EQ(whole, "{\n \"lines\": [\n  1.5,\n  \"two\"\n ],\n \"row\": {\"a\": 1, \"b\": 2}\n}\n");
}

TEST(JsonWriter, WhatIsPendingIsWhatADrainWillGive) {
  JsonWriter writer;
  EXPECT_EQ(writer.pending(), 0U);
  writer.begin_array(JsonLayout::Row);
  writer.value(12);
  EXPECT_EQ(writer.pending(), 3U);  // [12
  EXPECT_EQ(writer.drain(), "[12");
  EXPECT_EQ(writer.pending(), 0U);
  writer.end_array();
  EXPECT_EQ(writer.take(), "]\n");
}

TEST(JsonWriter, WritesOneTextAfterAnother) {
  JsonWriter writer;
  writer.begin_object(JsonLayout::Row);
  writer.end_object();
  std::string lines = writer.take();
  writer.begin_object(JsonLayout::Row);
  writer.member("n", 2);
  writer.end_object();
  lines += writer.take();
  EXPECT_EQ(lines, "{}\n{\"n\": 2}\n");
}

}  // namespace
}  // namespace meshalyzer
