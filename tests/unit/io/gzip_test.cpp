#include "meshalyzer/io/gzip.h"

#include "io_cases.h"

#include <gtest/gtest.h>

#include <string>

namespace meshalyzer {
namespace {

const std::string kText = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string unpack(const std::string& content) {
  return unpack_gzip(content, "a.gz");
}

/// Numbers that deflate cannot make short.
std::string noise(std::size_t n) {
  std::mt19937_64 random(20261122);
  std::string bytes(n, '\0');
  for (char& byte : bytes) {
    byte = static_cast<char>(random());
  }
  return bytes;
}

TEST(PackGzip, UnpacksToTheSameBytes) {
  for (const std::string& content :
       {std::string(), kText, noise(1U << 20U), std::string(99999, 'a')}) {
    EXPECT_TRUE(is_gzip(pack_gzip(content)));
    EXPECT_EQ(unpack(pack_gzip(content)), content);
  }
}

TEST(PackGzip, TheSameBytesGiveTheSameBytes) {
  EXPECT_EQ(pack_gzip(kText), pack_gzip(kText));
}

TEST(IsGzip, IsFalseForMeshesAndForNothing) {
  EXPECT_FALSE(is_gzip(kText));
  EXPECT_FALSE(is_gzip(""));
  EXPECT_FALSE(is_gzip("\x1f\x8b"));
}

TEST(UnpackGzip, MembersAreReadOneBehindTheOther) {
  EXPECT_EQ(unpack(pack_gzip("one ") + pack_gzip("two")), "one two");
}

TEST(UnpackGzip, ZerosBehindTheLastMemberArePadding) {
  EXPECT_EQ(unpack(pack_gzip(kText) + std::string(512, '\0')), kText);
}

TEST(UnpackGzip, OtherBytesBehindTheLastMemberAreRefused) {
  const std::string packed = pack_gzip(kText);
  EXPECT_EQ(error_of([&] { return unpack(packed + "more"); }),
            "a.gz:byte " + std::to_string(packed.size()) +
                ": 4 bytes behind the end of the gzipped data");
}

TEST(UnpackGzip, EveryCutIsRefusedAtItsEnd) {
  const std::string packed = pack_gzip(kText);
  for (std::size_t n = 3; n < packed.size(); ++n) {
    EXPECT_EQ(error_of([&] { return unpack(packed.substr(0, n)); }),
              "a.gz:byte " + std::to_string(n) + ": the gzipped data end too soon");
  }
}

TEST(UnpackGzip, AChangedByteIsNeverTakenForOtherContent) {
  const std::string packed = pack_gzip(kText);
  for (std::size_t i = 3; i < packed.size(); ++i) {
    std::string changed = packed;
    changed[i] = static_cast<char>(changed[i] ^ 0x55);
    try {
      EXPECT_EQ(unpack(changed), kText) << i;  // the header has bytes that mean nothing
    } catch (const IoError& error) {
      EXPECT_EQ(begin_like(error.what(), "a.gz:byte "), "a.gz:byte ");
    }
  }
}

TEST(UnpackGzip, WhatTakesMoreThanAThousandTimesItsSizeIsRefusedUnlessItIsAllowed) {
  // Deflate makes 1,032 bytes of one at most, so that ten million zeros are beyond the limit.
  const std::string zeros(10'000'000, '\0');
  const std::string bomb = pack_gzip(zeros);
  ASSERT_GT(zeros.size(), 1000 * bomb.size());
  EXPECT_NE(error_of([&] { return unpack(bomb); }).find("more than 1000 times their size"),
            std::string::npos);
  {
    const UnpackLimit limit(2000);
    EXPECT_EQ(unpack(bomb), zeros);
  }
  const UnpackLimit limit(1);
  EXPECT_NE(error_of([&] { return unpack(pack_gzip(std::string(9999, ' '))); }), "accepted");
}

}  // namespace
}  // namespace meshalyzer
