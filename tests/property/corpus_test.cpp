#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/report/json/report.h"
#include "support/effort.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

using nlohmann::json;

const std::string kCorpus = MESHALYZER_CORPUS;

bool has_corpus() {
  return std::filesystem::is_regular_file(kCorpus + "/expected.json");
}

std::string report_of(const std::string& file, std::size_t n_threads) {
  const ThreadLimit limit(n_threads);
  const std::vector<Analysis> meshes{analyze(read_mesh(file), file)};
  return json_report(meshes, nullptr, JsonOffenders::List);
}

bool is_real(const std::string& field) {
  return field == "area" || field == "volume";
}

void expect_field(const std::string& field, const json& expected, const json& actual) {
  if (!is_real(field) || expected.is_null()) {
    EXPECT_EQ(actual, expected) << field;
    return;
  }
  ASSERT_TRUE(actual.is_number()) << field << " is " << actual;
  const double value = expected.get<double>();
  EXPECT_NEAR(actual.get<double>(), value, 1e-7 * std::abs(value)) << field;
}

/// Expects every field of a file that the corpus tells, in every part of the report.
void expect_fields(const json& expected, const json& mesh) {
  for (const auto& [part, fields] : expected.items()) {
    for (const auto& [field, value] : fields.items()) {
      ASSERT_TRUE(mesh.at(part).contains(field)) << part << '.' << field;
      expect_field(field, value, mesh.at(part).at(field));
    }
  }
}

TEST(Corpus, EveryFigureOfRealMeshesIsThatOfTheIndependentJudge) {
  if (!has_corpus()) GTEST_SKIP() << "no corpus at " << kCorpus;
  std::ifstream in(kCorpus + "/expected.json");
  const json all = json::parse(in);
  EXPECT_FALSE(all.empty());
  const std::uintmax_t max_bytes = 20'000'000 / test::one_of() / test::one_of();
  for (const auto& [file, expected] : all.items()) {
    SCOPED_TRACE(file);
    if (std::filesystem::file_size(kCorpus + '/' + file) > max_bytes) continue;
    const std::string one = report_of(kCorpus + '/' + file, 1);
    EXPECT_TRUE(one == report_of(kCorpus + '/' + file, 2))
        << "two threads give another report than one";
    expect_fields(expected, json::parse(one).at("meshes").at(0));
  }
}

TEST(Corpus, FilesThatAreNoMeshesAreRefused) {
  if (!has_corpus()) GTEST_SKIP() << "no corpus at " << kCorpus;
  std::size_t n_files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kCorpus + "/unreadable")) {
    SCOPED_TRACE(entry.path().string());
    EXPECT_THROW(static_cast<void>(read_mesh(entry.path().string())), IoError);
    ++n_files;
  }
  EXPECT_GT(n_files, 0U);
}

}  // namespace
}  // namespace meshalyzer
