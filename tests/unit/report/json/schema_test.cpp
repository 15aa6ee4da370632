#include "meshalyzer/report/json/schema.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace meshalyzer {
namespace {

TEST(JsonSchema, IsWhatDocReportSchemaShows) {
  const std::string path = MESHALYZER_MESHES "/../doc/report.schema.json";
  const char* const update = std::getenv("UPDATE");
  if (update != nullptr && *update != '\0' && *update != '0') {
    std::ofstream(path, std::ios::binary) << json_schema();
  }
  std::ifstream file(path, std::ios::binary);
  const std::string shown{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  EXPECT_EQ(shown, json_schema()) << "UPDATE=1 in the environment rewrites it";
}

}  // namespace
}  // namespace meshalyzer
