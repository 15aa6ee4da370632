#include "meshalyzer/checks/selection.h"

#include "meshalyzer/checks/profile.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

CheckCriteria solid_with(const std::vector<std::string>& selected,
                         const std::vector<std::string>& ignored) {
  CheckCriteria criteria = find_profile("solid")->criteria;
  select_codes(selected, ignored, criteria);
  return criteria;
}

TEST(SelectCodes, NothingNamedChangesNothing) {
  EXPECT_EQ(solid_with({}, {}).codes, find_profile("solid")->criteria.codes);
}

TEST(SelectCodes, SelectedOnesAreAllThatIsLookedFor) {
  const CheckCriteria criteria = solid_with({"hole", "disjoint"}, {});
  EXPECT_EQ(criteria.codes, (DefectCodes{DefectCode::Hole, DefectCode::Disjoint}));
  EXPECT_FALSE(criteria.limits[LimitKind::MinFaces]);
}

TEST(SelectCodes, IgnoredOnesAreNotLookedFor) {
  const CheckCriteria criteria = solid_with({}, {"hole", "min-faces"});
  EXPECT_FALSE(criteria.codes.contains(DefectCode::Hole));
  EXPECT_TRUE(criteria.codes.contains(DefectCode::Slit));
  EXPECT_FALSE(criteria.limits[LimitKind::MinFaces]);
}

TEST(SelectCodes, AllButSome) {
  DefectCodes expected = DefectCodes::all();
  expected.erase(DefectCode::Numbering);
  EXPECT_EQ(solid_with({"all"}, {"numbering"}).codes, expected);
}

TEST(NearestCheckCode, MistypedCodeIsFoundAndNonsenseIsNot) {
  EXPECT_EQ(nearest_check_code("self-intersections"), "self-intersection");
  EXPECT_EQ(nearest_check_code("max-aspectratio"), "max-aspect-ratio");
  EXPECT_EQ(nearest_check_code("unicorn"), "");
}

}  // namespace
}  // namespace meshalyzer
