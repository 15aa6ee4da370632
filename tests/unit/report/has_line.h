#pragma once

#include <gmock/gmock.h>

#include <string>

namespace meshalyzer::test {

/// Tells whether a report has exactly this line.
inline testing::Matcher<std::string> HasLine(const std::string& line) {
  return testing::AnyOf(testing::StartsWith(line + "\n"), testing::HasSubstr("\n" + line + "\n"));
}

}  // namespace meshalyzer::test
