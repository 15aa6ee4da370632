#include "meshalyzer/base/control_characters.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

TEST(WithoutControls, WhatEndsALineOrSteersATerminalIsReplaced) {
  EXPECT_EQ(without_controls("a\nb\x1B[31mc\x7F"), "a?b?[31mc?");
  // U+0085 ends a line, U+009B begins commands as escape and bracket do.
  EXPECT_EQ(without_controls("a\u0085b\u009B31mc"), "a?b?31mc");
}

TEST(WithoutControls, WhatTurnsTheTextAfterItRoundIsReplaced) {
  EXPECT_EQ(without_controls("a\u202Ex.obj, b\u2066.obj"), "a?x.obj, b?.obj");
}

TEST(WithoutControls, AllOtherBytesStay) {
  EXPECT_EQ(without_controls("Grüße שלום \u00A0\u2029\u202F\u2065\u206A"),
            "Grüße שלום \u00A0\u2029\u202F\u2065\u206A");
  EXPECT_EQ(without_controls("\xFF\xC2"
                             "x\xE2\x80"),
            "\xFF\xC2"
            "x\xE2\x80");
}

}  // namespace
}  // namespace meshalyzer
