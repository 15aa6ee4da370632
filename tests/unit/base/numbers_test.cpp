#include "meshalyzer/base/numbers.h"

#include "support/constants.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace meshalyzer {
namespace {

TEST(Shortest, IsTheShortestTextOfTheDouble) {
  EXPECT_EQ(shortest(6.0), "6");
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(-2.5), "-2.5");
  EXPECT_EQ(shortest(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(shortest(1e300), "1e+300");
}

TEST(Readable, TenDigitsAtMost) {
  EXPECT_EQ(readable(6.0), "6");
  EXPECT_EQ(readable(0.1 + 0.2), "0.3");
  EXPECT_EQ(readable(2.0 / 3.0), "0.6666666667");
  EXPECT_EQ(readable(-12345678901.5), "-1.23456789e+10");
  EXPECT_EQ(readable(1e-300), "1e-300");
  EXPECT_EQ(readable(-0.0), "0");
  EXPECT_EQ(readable(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(Shortest, KeepsTheSignOfZero) {
  EXPECT_EQ(shortest(0.0), "0");
  EXPECT_EQ(shortest(-0.0), "-0");
}

TEST(Shortest, NamesWhatIsNotFinite) {
  EXPECT_EQ(shortest(kInfinity), "inf");
  EXPECT_EQ(shortest(-kInfinity), "-inf");
  EXPECT_EQ(shortest(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(AppendShortest, LeavesWhatStandsBefore) {
  std::string text = "x ";
  append_shortest(text, 0.5);
  EXPECT_EQ(text, "x 0.5");
}

TEST(ParseReal, ReadsBackEveryShortestTextToTheBit) {
  std::mt19937_64 random(20090501);
  for (int i = 0; i < 100000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (std::isfinite(value)) {
      const auto read = parse_real(shortest(value));
      ASSERT_TRUE(read.has_value()) << shortest(value);
      ASSERT_EQ(std::bit_cast<std::uint64_t>(*read), std::bit_cast<std::uint64_t>(value))
          << shortest(value);
    }
  }
}

TEST(ParseReal, AcceptsEveryWayOfWritingANumber) {
  for (const char* text :
       {"1000", "+1000", "1e3", "1E3", "1e+3", "1000.", "1000.0", "001000", "10000e-1", ".1e4"}) {
    EXPECT_EQ(parse_real(text), 1000.0) << text;
  }
}

TEST(ParseReal, RefusesWhatIsNotOneNumber) {
  for (const char* text : {"", "+", "-", ".", "e5", "1e", "1e+", "1,5", "1 ", " 1", "1x", "0x10",
                           "+-1", "++1", "--1"}) {
    EXPECT_EQ(parse_real(text), std::nullopt) << text;
  }
}

TEST(ParseReal, TooLargeBecomesInfinite) {
  EXPECT_EQ(parse_real("1e999"), kInfinity);
  EXPECT_EQ(parse_real("-1e999"), -kInfinity);
  EXPECT_EQ(parse_real("1" + std::string(400, '0')), kInfinity);
}

TEST(ParseReal, TooSmallBecomesZeroOfItsSign) {
  EXPECT_EQ(parse_real("1e-999"), 0.0);
  EXPECT_EQ(parse_real("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_TRUE(std::signbit(parse_real("-1e-999").value_or(1.0)));
}

TEST(ParseReal, ReadsTheEndsOfTheRange) {
  EXPECT_EQ(parse_real("5e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(parse_real("1.7976931348623157e308"), std::numeric_limits<double>::max());
}

TEST(ParseInteger, ReadsSignedIntegers) {
  EXPECT_EQ(parse_integer("0"), 0);
  EXPECT_EQ(parse_integer("-17"), -17);
  EXPECT_EQ(parse_integer("+17"), 17);
  EXPECT_EQ(parse_integer("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
}

TEST(ParseInteger, RefusesWhatDoesNotFitOrIsNoInteger) {
  for (const char* text : {"", "-", "+", "1.0", "1e3", "x", "1x", " 1", "9223372036854775808"}) {
    EXPECT_EQ(parse_integer(text), std::nullopt) << text;
  }
}

TEST(ParseReal, OutOfRangeIsToldByTheFirstDigitThatCounts) {
  const std::string zeros(400, '0');
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(parse_real("1" + zeros + "e-5"), infinity);
  EXPECT_EQ(parse_real("0." + zeros + "1e5"), 0.0);
  EXPECT_EQ(parse_real("-1e400"), -infinity);
  EXPECT_EQ(parse_real("1e-400"), 0.0);
  EXPECT_EQ(parse_real("1e99999999999999999999"), infinity);
  EXPECT_EQ(parse_real("1e-99999999999999999999"), 0.0);
}

}  // namespace
}  // namespace meshalyzer
