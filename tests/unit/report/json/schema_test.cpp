#include "meshalyzer/report/json/schema.h"

#include "meshalyzer/report/check/formats.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace meshalyzer {
namespace {

/// Compares a schema with what the documentation shows.
void expect_shown(const std::string& name, const std::string& schema) {
  const std::string path = MESHALYZER_MESHES "/../doc/" + name;
  const char* const update = std::getenv("UPDATE");
  if (update != nullptr && *update != '\0' && *update != '0') {
    std::ofstream(path, std::ios::binary) << schema;
  }
  std::ifstream file(path, std::ios::binary);
  const std::string shown{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  EXPECT_EQ(shown, schema) << "UPDATE=1 in the environment rewrites it";
}

TEST(JsonSchema, IsWhatDocReportSchemaShows) {
  expect_shown("report.schema.json", json_schema());
}

TEST(CheckJsonSchema, IsWhatDocCheckSchemaShows) {
  expect_shown("check.schema.json", check_json_schema());
}

}  // namespace
}  // namespace meshalyzer
