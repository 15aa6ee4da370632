#include "meshalyzer/base/error.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

TEST(IoError, WithALineReadsFileLineMessage) {
  const IoError error("cube.obj", {.line = 17}, "no face");
  EXPECT_STREQ(error.what(), "cube.obj:17: no face");
  EXPECT_EQ(error.file(), "cube.obj");
  EXPECT_EQ(error.place().line, 17U);
}

TEST(IoError, WithAByteOffsetNamesIt) {
  EXPECT_STREQ(IoError("a.stl", {.byte = 0}, "cut").what(), "a.stl:byte 0: cut");
}

TEST(IoError, WithoutAPlaceNamesTheFileAlone) {
  EXPECT_STREQ(IoError("a.stl", {}, "no such file").what(), "a.stl: no such file");
}

TEST(IoError, IsOnOneLine) {
  const IoError error("a\nb\x1B[2J\x7F.stl", {.line = 1}, "no face");
  EXPECT_STREQ(error.what(), "a?b?[2J?.stl:1: no face");
  EXPECT_EQ(error.file(), "a\nb\x1B[2J\x7F.stl");
}

TEST(Error, IsTheBaseOfAllThatIsThrown) {
  EXPECT_THROW(throw IoError("a", {}, "b"), Error);
  EXPECT_THROW(throw InvalidArgument("b"), Error);
}

}  // namespace
}  // namespace meshalyzer
