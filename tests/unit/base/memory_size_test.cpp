#include "meshalyzer/base/memory_size.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace meshalyzer {
namespace {

constexpr std::uint64_t kKilo = 1024;
constexpr std::uint64_t kMega = 1024 * kKilo;
constexpr std::uint64_t kGiga = 1024 * kMega;
constexpr std::uint64_t kTera = 1024 * kGiga;

TEST(ParseMemorySize, LettersArePowersOfTwo) {
  EXPECT_EQ(parse_memory_size("4096"), 4096U);
  EXPECT_EQ(parse_memory_size("3k"), 3 * kKilo);
  EXPECT_EQ(parse_memory_size("3K"), 3 * kKilo);
  EXPECT_EQ(parse_memory_size("500M"), 500 * kMega);
  EXPECT_EQ(parse_memory_size("2G"), 2 * kGiga);
  EXPECT_EQ(parse_memory_size("1T"), kTera);
}

TEST(ParseMemorySize, BytesMayBeNamed) {
  EXPECT_EQ(parse_memory_size("4096B"), 4096U);
  EXPECT_EQ(parse_memory_size("2GB"), 2 * kGiga);
  EXPECT_EQ(parse_memory_size("2GiB"), 2 * kGiga);
  EXPECT_EQ(parse_memory_size("2kiB"), 2 * kKilo);
}

TEST(ParseMemorySize, FractionsAreOfTheUnitAndDropWhatIsLessThanAByte) {
  EXPECT_EQ(parse_memory_size("1.5G"), kGiga + kGiga / 2);
  EXPECT_EQ(parse_memory_size("0.25K"), 256U);
  EXPECT_EQ(parse_memory_size("1.0M"), kMega);
  EXPECT_EQ(parse_memory_size("1.0001K"), 1024U);  // 1024.1024
  EXPECT_EQ(parse_memory_size("7.9"), 7U);
  EXPECT_EQ(parse_memory_size("0.99999999999999999999T"), kTera - 1);
}

TEST(ParseMemorySize, WhatIsNoAmountIsNothing) {
  for (const std::string_view text :
       {"",    "G",     "-1",   "+1",  "0",     "0G",     "0.0", "0.5", ".5G",
        "1.",  "1.G",   "1..5", " 1G", "1G ",   "1 G",    "1g",  "1m",  "1GBB",
        "1Gi", "1iB",   "1kb",  "1e3", "0x10",  "inf",    "nan", "1,5", "1P",
        "G1",  "1.5.2", "1-2",  "1BG", "1.-5G", "1.5e3M", "1_0", "١",   "1GiBx"}) {
    EXPECT_EQ(parse_memory_size(text), std::nullopt) << text;
  }
}

TEST(ParseMemorySize, TheLargestNumberOfBytesFitsAndNoMore) {
  EXPECT_EQ(parse_memory_size("18446744073709551615"), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(parse_memory_size("18446744073709551616"), std::nullopt);
  // 2^64 bytes are 2^24 T.
  EXPECT_EQ(parse_memory_size("16777215.5T"), 16777215 * kTera + kTera / 2);
  EXPECT_EQ(parse_memory_size("16777216T"), std::nullopt);
  EXPECT_EQ(parse_memory_size("16777217T"), std::nullopt);
  EXPECT_EQ(parse_memory_size("18014398509481983.9999K"),
            std::numeric_limits<std::uint64_t>::max());
}

TEST(PhysicalMemory, IsThatOfAMachineThatRunsThis) {
  EXPECT_GT(physical_memory(), 16 * kMega);
  EXPECT_LT(physical_memory(), 1024 * kTera);
}

}  // namespace
}  // namespace meshalyzer
