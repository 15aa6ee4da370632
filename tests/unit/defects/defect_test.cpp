#include "meshalyzer/defects/defect.h"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace meshalyzer {
namespace {

TEST(DefectName, IsTheCodeThatIsNeverRenamed) {
  EXPECT_EQ(defect_name(DefectCode::Disjoint), "disjoint");
  EXPECT_EQ(defect_name(DefectCode::Foldover), "foldover");
  EXPECT_EQ(defect_name(DefectCode::FlatFacet), "flat-facet");
  EXPECT_EQ(defect_name(DefectCode::DegenerateFacet), "degenerate-facet");
  EXPECT_EQ(defect_name(DefectCode::Slit), "slit");
  EXPECT_EQ(defect_name(DefectCode::SelfIntersection), "self-intersection");
  EXPECT_EQ(defect_name(DefectCode::NonManifold), "non-manifold");
  EXPECT_EQ(defect_name(DefectCode::VertexNormal), "vertex-normal");
  EXPECT_EQ(defect_name(DefectCode::Corrupt), "corrupt");
  EXPECT_EQ(defect_name(DefectCode::Hole), "hole");
  EXPECT_EQ(defect_name(DefectCode::Flipped), "flipped");
  EXPECT_EQ(defect_name(DefectCode::Inward), "inward");
  EXPECT_EQ(defect_name(DefectCode::DuplicateFacet), "duplicate-facet");
  EXPECT_EQ(defect_name(DefectCode::OrphanVertex), "orphan-vertex");
  EXPECT_EQ(defect_name(DefectCode::Numbering), "numbering");
}

TEST(DefectCode, IsFoundByItsName) {
  std::set<std::string_view> names;
  for (const DefectCode code : all_defect_codes()) {
    EXPECT_EQ(defect_code(defect_name(code)), code);
    names.insert(defect_name(code));
  }
  EXPECT_EQ(names.size(), kDefectCodes);
}

TEST(DefectCode, IsNotFoundByAnyOtherName) {
  EXPECT_FALSE(defect_code(""));
  EXPECT_FALSE(defect_code("hol"));
  EXPECT_FALSE(defect_code("holes"));
  EXPECT_FALSE(defect_code("Hole"));
}

TEST(DefectCodes, HoldWhatWasInsertedAndNotErased) {
  DefectCodes codes{DefectCode::Hole, DefectCode::Numbering};
  EXPECT_TRUE(codes.contains(DefectCode::Hole));
  EXPECT_FALSE(codes.contains(DefectCode::Slit));
  codes.erase(DefectCode::Hole);
  EXPECT_EQ(codes, DefectCodes{DefectCode::Numbering});
  codes.erase(DefectCode::Numbering);
  EXPECT_TRUE(codes.empty());
}

TEST(DefectCodes, OfAllHoldEveryCode) {
  for (const DefectCode code : all_defect_codes()) EXPECT_TRUE(DefectCodes::all().contains(code));
}

TEST(SeverityName, IsTheLowerCaseWord) {
  EXPECT_EQ(severity_name(Severity::Error), "error");
  EXPECT_EQ(severity_name(Severity::Warning), "warning");
}

}  // namespace
}  // namespace meshalyzer
