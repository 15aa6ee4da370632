#include "meshalyzer/defects/catalogue.h"

#include "defects_page.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>

namespace meshalyzer {
namespace {

TEST(DefectCatalogue, SaysAllOfEveryCode) {
  ASSERT_EQ(defect_catalogue().size(), kDefectCodes);
  for (const DefectCode code : all_defect_codes()) {
    SCOPED_TRACE(defect_name(code));
    const CatalogueEntry& entry = catalogue_entry(code);
    EXPECT_EQ(entry.code, code);
    for (const std::string_view said : {entry.meaning, entry.elements, entry.fix}) {
      ASSERT_FALSE(said.empty());
      EXPECT_EQ(said.back(), '.');
    }
  }
}

TEST(DefectCatalogue, EachCodeHasItsOwnNameAndSummary) {
  std::set<std::string_view> names;
  std::set<std::string_view> summaries;
  for (const CatalogueEntry& entry : defect_catalogue()) {
    EXPECT_FALSE(entry.name.empty());
    EXPECT_FALSE(entry.summary.empty());
    names.insert(entry.name);
    summaries.insert(entry.summary);
  }
  EXPECT_EQ(names.size(), kDefectCodes);
  EXPECT_EQ(summaries.size(), kDefectCodes);
}

TEST(DefectCatalogue, AllIsFixedByDefaultButWhatMayBeMeant) {
  for (const CatalogueEntry& entry : defect_catalogue()) {
    const bool may_be_meant =
        entry.code == DefectCode::Disjoint || entry.code == DefectCode::Numbering;
    EXPECT_EQ(entry.fixed_by_default, !may_be_meant) << defect_name(entry.code);
  }
}

TEST(MakeDefect, IsAsSevereAsTheCatalogueSays) {
  EXPECT_EQ(make_defect(DefectCode::Hole).code, DefectCode::Hole);
  EXPECT_EQ(make_defect(DefectCode::Hole).severity, Severity::Error);
  EXPECT_EQ(make_defect(DefectCode::OrphanVertex).severity, Severity::Warning);
}

TEST(DefectsPage, IsWhatDocDefectsShows) {
  const std::string path = MESHALYZER_MESHES "/../doc/defects.md";
  const char* const update = std::getenv("UPDATE");
  if (update != nullptr && *update != '\0' && *update != '0') {
    std::ofstream(path, std::ios::binary) << defects_page();
  }
  std::ifstream file(path, std::ios::binary);
  const std::string shown{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  EXPECT_EQ(shown, defects_page()) << "UPDATE=1 in the environment rewrites it";
}

}  // namespace
}  // namespace meshalyzer
