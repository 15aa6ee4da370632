#include "meshalyzer/report/json/tree.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>

namespace meshalyzer {
namespace {

double real_of(const std::string& text) {
  return JsonTree(text).root().real();
}

std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "nothing thrown";
}

std::string message_of_text(const std::string& text) {
  return message_of([&] { const JsonTree tree(text); });
}

void expect_same_bits(double value) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(real_of(shortest(value))),
            std::bit_cast<std::uint64_t>(value))
      << shortest(value);
}

TEST(JsonTree, RealsComeBackBitByBit) {
  using Limits = std::numeric_limits<double>;
  for (const double value :
       {0.0, -0.0, 0.1, -1.0 / 3.0, 1e22, 1e23, 9007199254740993.0, 123456789012345678.0,
        9223372036854775808.0, 18446744073709551616.0, Limits::max(), Limits::min(),
        Limits::denorm_min(), -Limits::denorm_min()}) {
    expect_same_bits(value);
  }
}

TEST(JsonTree, RealsOfAnyBitsComeBackBitByBit) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (std::isfinite(value)) {
      expect_same_bits(value);
    }
  }
}

TEST(JsonTree, RealsDoNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  const bool has_comma = std::setlocale(LC_NUMERIC, "de_DE.UTF-8") != nullptr ||
                         std::setlocale(LC_NUMERIC, "de_DE.utf8") != nullptr;
  if (!has_comma) GTEST_SKIP() << "no locale with a decimal comma";
  expect_same_bits(1.0 / 3.0);
  std::setlocale(LC_NUMERIC, before.c_str());
}

TEST(JsonTree, ScalarsAreWhatTheTextSays) {
  const JsonTree tree(R"({"yes": true, "no": false, "none": null, "n": -7, "text": "a\n\u00e9"})");
  const JsonNode root = tree.root();
  EXPECT_TRUE(root.member("yes").truth());
  EXPECT_FALSE(root.member("no").truth());
  EXPECT_TRUE(root.member("none").is_null());
  EXPECT_FALSE(root.member("no").is_null());
  EXPECT_EQ(root.member("n").integer(), -7);
  EXPECT_EQ(root.member("n").real(), -7.0);
  EXPECT_EQ(root.member("text").text(), "a\n\xC3\xA9");
  EXPECT_FALSE(root.find("other").has_value());
}

TEST(JsonTree, MembersBehindNestedOnesAreFound) {
  const JsonTree tree(R"({"a": [[1, {"z": 2}], []], "b": {"z": {}}, "long": "text", "z": 3})");
  EXPECT_EQ(tree.root().member("z").integer(), 3);
}

TEST(JsonTree, ElementsComeInTheirOrder) {
  const JsonTree tree("[[1, [2]], {}, 4]");
  JsonElements elements = tree.root().elements();
  JsonElements first = elements.next().elements();
  EXPECT_EQ(first.next().integer(), 1);
  EXPECT_EQ(first.next().elements().next().integer(), 2);
  EXPECT_TRUE(first.at_end());
  EXPECT_FALSE(elements.next().find("a").has_value());
  EXPECT_FALSE(elements.at_end());
  EXPECT_EQ(elements.next().integer(), 4);
  EXPECT_NO_THROW(elements.expect_end());
}

TEST(JsonTree, ListOfAnotherLengthIsRefused) {
  const JsonTree tree("[1]");
  JsonElements elements = tree.root().elements();
  EXPECT_THROW(elements.expect_end(), InvalidArgument);
  static_cast<void>(elements.next());
  EXPECT_THROW(static_cast<void>(elements.next()), InvalidArgument);
}

TEST(JsonTree, ValueOfAnotherKindIsRefusedByItsPlace) {
  const JsonTree tree(R"({"a": 1, "b": [{"c": "x"}, {"c": [5, 2.5, -1, true]}]})");
  JsonElements list = tree.root().member("b").elements();
  static_cast<void>(list.next());
  JsonElements values = list.next().member("c").elements();
  const JsonNode five = values.next();
  const JsonNode real = values.next();
  const JsonNode negative = values.next();
  const JsonNode truth = values.next();
  EXPECT_EQ(message_of([&] { static_cast<void>(five.text()); }), "b[1].c[0]: not a text");
  EXPECT_EQ(message_of([&] { static_cast<void>(real.integer()); }), "b[1].c[1]: not an integer");
  EXPECT_EQ(message_of([&] { static_cast<void>(negative.count()); }), "b[1].c[2]: negative");
  EXPECT_EQ(message_of([&] { static_cast<void>(truth.real()); }), "b[1].c[3]: not a number");
  EXPECT_EQ(message_of([&] { static_cast<void>(five.truth()); }),
            "b[1].c[0]: neither true nor false");
  EXPECT_EQ(message_of([&] { static_cast<void>(five.elements()); }), "b[1].c[0]: not a list");
  EXPECT_EQ(message_of([&] { static_cast<void>(five.find("x")); }), "b[1].c[0]: not an object");
  EXPECT_EQ(message_of([&] { static_cast<void>(tree.root().member("d")); }),
            "the JSON value: has no \"d\"");
}

TEST(JsonTree, WhatIsNoJsonIsRefusedByItsByte) {
  EXPECT_THAT(message_of_text(R"({"a": 1, "b)"), testing::HasSubstr("byte 12"));
  EXPECT_THAT(message_of_text("[1, x]"), testing::HasSubstr("byte 5"));
}

TEST(JsonTree, TextThatIsNotOneValueIsRefused) {
  for (const char* text : {"", " ", "{", "[1", "{} {}", "{} x", "nan", "[1,]", "{\"a\"}", "\"a",
                           "\"\xE9\"", "1e999", "{1: 2}"}) {
    EXPECT_NE(message_of_text(text), "nothing thrown") << text;
  }
}

TEST(JsonTree, NestingOfAnyDepthIsRead) {
  constexpr std::size_t kDepth = 1000000;
  const JsonTree tree(std::string(kDepth, '[') + std::string(kDepth, ']'));
  EXPECT_FALSE(tree.root().elements().at_end());
}

}  // namespace
}  // namespace meshalyzer
