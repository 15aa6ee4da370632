#include "meshalyzer/base/eight_lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <random>

namespace meshalyzer {
namespace {

using Random = std::mt19937;

/// Numbers that are easily taken for each other, and some that compare oddly.
template <typename Number>
std::array<Number, 8> any_eight(const std::array<Number, 8>& choice, Random& random) {
  std::array<Number, 8> numbers;
  for (Number& number : numbers) {
    number = choice[random() % choice.size()];
  }
  return numbers;
}

using Limits = std::numeric_limits<float>;
constexpr std::array<float, 8> kFloats{0.0F,
                                       -0.0F,
                                       Limits::denorm_min(),
                                       1.0F,
                                       1.0F + Limits::epsilon(),
                                       Limits::infinity(),
                                       -Limits::infinity(),
                                       Limits::quiet_NaN()};
constexpr std::array<std::uint32_t, 8> kIds{0U,          1U,          0x7FFFFFFFU, 0x80000000U,
                                            0x80000001U, 0xFFFFFFFEU, 0xFFFFFFFFU, 2U};

TEST(EightLanes, SaysOfEachLaneWhetherItIsLess) {
  const auto a = EightFloats::load({0, 1, 2, 3, 4, 5, 6, 7});
  EXPECT_EQ((a < EightFloats::all(3.0F)).bits(), 0b00000111U);
  EXPECT_EQ((EightFloats::all(5.0F) < a).bits(), 0b11000000U);
  EXPECT_EQ(((a < EightFloats::all(1.0F)) | (EightFloats::all(6.0F) < a)).bits(), 0b10000001U);
  EXPECT_EQ(((a < EightFloats::all(6.0F)) & (EightFloats::all(3.0F) < a)).bits(), 0b00110000U);
  EXPECT_EQ((a <= EightFloats::all(3.0F)).bits(), 0b00001111U);
}

TEST(EightLanes, SelectsByFlag) {
  const std::array<float, 8> numbers{0, 1, 2, 3, 4, 5, 6, 7};
  const auto a = EightFloats::load(numbers);
  const auto selected = select(a < EightFloats::all(2.0F), EightFloats::all(9.0F), a);
  EXPECT_EQ(selected.numbers(), (std::array<float, 8>{9, 9, 2, 3, 4, 5, 6, 7}));
}

TEST(EightLanes, SaysOfEachLaneWhetherItIsTheSameId) {
  const auto a = EightIds::load({7, 6, 7, 4, 3, 2, 1, 7});
  EXPECT_EQ((a == EightIds::all(7)).bits(), 0b10000101U);
}

/// The lanes of what an operation of one set of types gives, as bits, so that zeros and numbers
/// that are none are told apart.
std::array<std::uint32_t, 8> bits_of(const EightFloats& numbers) {
  return std::bit_cast<std::array<std::uint32_t, 8>>(numbers);
}
std::array<std::uint32_t, 8> portable_bits_of(const portable::EightFloats& numbers) {
  return std::bit_cast<std::array<std::uint32_t, 8>>(numbers);
}

TEST(EightLanes, ArithmeticOfRegistersAndOfThePortablePathGivesTheSameBits) {
  Random random(2);
  // NaN is left out, because its sign and payload do not matter.
  constexpr std::array<float, 8> kNumbers{0.0F,         -0.0F,          0x1p-149F, 1.0F,
                                          -0x1.8p-126F, 0x1.fffffep99F, -3e-20F,   0.1F};
  for (int round = 0; round < 2000; ++round) {
    const auto x = any_eight(kNumbers, random);
    const auto y = any_eight(kNumbers, random);
    const auto a = EightFloats::load(x);
    const auto b = EightFloats::load(y);
    const auto p = portable::EightFloats::load(x);
    const auto q = portable::EightFloats::load(y);
    EXPECT_EQ(bits_of(a + b), portable_bits_of(p + q));
    EXPECT_EQ(bits_of(a - b), portable_bits_of(p - q));
    EXPECT_EQ(bits_of(a * b), portable_bits_of(p * q));
    if (std::ranges::none_of(y, [](float number) { return number == 0.0F; })) {
      EXPECT_EQ(bits_of(a / b), portable_bits_of(p / q));
    }
    EXPECT_EQ(bits_of(min(a, b)), portable_bits_of(min(p, q)));
    EXPECT_EQ(bits_of(max(a, b)), portable_bits_of(max(p, q)));
    EXPECT_EQ(bits_of(select(a < b, a, b)), portable_bits_of(select(p < q, p, q)));
    EXPECT_EQ(a.numbers(), p.numbers());
  }
}

TEST(EightLanes, FlagsOfNothingAreNotSet) {
  EXPECT_EQ(EightFlags{}.bits(), 0U);
}

TEST(EightLanes, RegistersAndThePortablePathGiveTheSameBits) {
  Random random(1);
  for (int round = 0; round < 2000; ++round) {
    const auto x = any_eight(kFloats, random);
    const auto y = any_eight(kFloats, random);
    EXPECT_EQ((EightFloats::load(x) < EightFloats::load(y)).bits(),
              (portable::EightFloats::load(x) < portable::EightFloats::load(y)).bits());
    EXPECT_EQ((EightFloats::load(x) < EightFloats::all(y[0])).bits(),
              (portable::EightFloats::load(x) < portable::EightFloats::all(y[0])).bits());
    EXPECT_EQ((EightFloats::load(x) <= EightFloats::load(y)).bits(),
              (portable::EightFloats::load(x) <= portable::EightFloats::load(y)).bits());
    const auto is_less = EightFloats::load(x) < EightFloats::load(y);
    const auto is_no_more = EightFloats::load(y) <= EightFloats::all(x[0]);
    const auto is_less_there = portable::EightFloats::load(x) < portable::EightFloats::load(y);
    const auto is_no_more_there =
        portable::EightFloats::load(y) <= portable::EightFloats::all(x[0]);
    EXPECT_EQ((is_less | is_no_more).bits(), (is_less_there | is_no_more_there).bits());
    EXPECT_EQ((is_less & is_no_more).bits(), (is_less_there & is_no_more_there).bits());
    const auto ids = any_eight(kIds, random);
    const auto others = any_eight(kIds, random);
    EXPECT_EQ((EightIds::load(ids) == EightIds::load(others)).bits(),
              (portable::EightIds::load(ids) == portable::EightIds::load(others)).bits());
    EXPECT_EQ((EightIds::load(ids) == EightIds::all(others[0])).bits(),
              (portable::EightIds::load(ids) == portable::EightIds::all(others[0])).bits());
  }
}

}  // namespace
}  // namespace meshalyzer
