#include "meshalyzer/io/decimal.h"

#include "io_cases.h"
#include "meshalyzer/base/numbers.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

namespace meshalyzer {
namespace {

Decimal<double> scan(const std::string& text) {
  return scan_real(text.data(), text.data() + text.size());
}

TEST(ScanReal, AgreesWithTheLibraryToTheBit) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 200000; ++i) {
    // Few digits, up to nineteen, and more or an exponent: what each way of reading is for.
    std::string text = std::to_string(random() >> (random() % 64));
    text.insert(text.begin() + static_cast<std::ptrdiff_t>(random() % (text.size() + 1)), '.');
    if (random() % 2 == 0) {
      text.insert(text.begin(), '-');
    }
    if (random() % 4 == 0) {
      text.append("e").append(std::to_string(static_cast<int>(random() % 60) - 30));
    }
    const auto expected = parse_real(text);
    ASSERT_TRUE(expected.has_value()) << text;
    const Decimal<double> got = scan(text);
    ASSERT_NE(got.end, nullptr) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(got.value), std::bit_cast<std::uint64_t>(*expected))
        << text;
  }
}

TEST(ScanReal, RoundsHalfToEven) {
  // Between 2^53 and 2^54 doubles are 2 apart, so that these lie in the middle of two.
  EXPECT_EQ(scan("9007199254740993").value, 0x1p53);
  EXPECT_EQ(scan("9007199254740995").value, 0x1p53 + 4);
  EXPECT_EQ(scan("-9007199254740993").value, -0x1p53);
  // As near to the middle as nineteen digits go, on either side; the exact middle behind a point.
  EXPECT_EQ(scan("9007199254740993.001").value, 0x1p53 + 2);
  EXPECT_EQ(scan("9007199254740992.999").value, 0x1p53);
  EXPECT_EQ(scan("4503599627370496.5").value, 0x1p52);
  EXPECT_EQ(scan("4503599627370497.500").value, 0x1p52 + 2);
}

TEST(ScanReal, EndsWhereTheNumberEnds) {
  const std::string text = "1.25 7";
  const Decimal<double> number = scan_real(text.data(), text.data() + text.size());
  EXPECT_EQ(number.value, 1.25);
  EXPECT_EQ(number.end, text.data() + 4);
}

TEST(ScanReal, NumbersTooSmallForADoubleAreZero) {
  EXPECT_EQ(scan("1e-400").value, 0.0);
  EXPECT_NE(scan("1e-400").end, nullptr);
  EXPECT_TRUE(std::signbit(scan("-2.5e-999").value));
}

TEST(ScanReal, LeavesWhatIsNotFinite) {
  for (const char* text : {"nan", "inf", "-inf", "infinity", "1e999"}) {
    EXPECT_EQ(scan(text).end, nullptr) << text;
  }
}

TEST(ScanReal, LeavesWhatIsNoNumber) {
  for (const char* text : {"", "-", ".", "-.", "e5", "x"}) {
    EXPECT_EQ(scan(text).end, nullptr) << text;
  }
}

TEST(ScanDigits, LeavesWhatMayNotFit) {
  const std::string fits(18, '9');
  EXPECT_EQ(scan_digits(fits.data(), fits.data() + 18).value, 999999999999999999);
  const std::string too_long(19, '9');
  EXPECT_EQ(scan_digits(too_long.data(), too_long.data() + 19).end, nullptr);
}

}  // namespace
}  // namespace meshalyzer
