#include "meshalyzer/report/text/boolean_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

using testing::HasSubstr;

TEST(TextReportOfBoolean, SingleWholeFaceIsInTheSingular) {
  BooleanReport report;
  report.operands = {{.name = "a.mesh", .n_faces = 12, .n_whole = 1, .n_cut = 3, .n_gone = 8}};
  EXPECT_THAT(text_report(report), HasSubstr("kept: 1 face whole, 3 in parts, 8 gone\n"));
}

}  // namespace
}  // namespace meshalyzer
