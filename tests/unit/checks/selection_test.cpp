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

TEST(WhyNoCheckCode, MistypedCodeIsFoundAndNonsenseIsNot) {
  EXPECT_EQ(why_no_check_code("self-intersection"), "");
  EXPECT_EQ(why_no_check_code("max-aspect-ratio"), "");
  EXPECT_EQ(why_no_check_code("all"), "");
  EXPECT_EQ(why_no_check_code("self-intersections"),
            "no code is called 'self-intersections'; did you mean 'self-intersection'?");
  EXPECT_EQ(why_no_check_code("max-aspectratio"),
            "no code is called 'max-aspectratio'; did you mean 'max-aspect-ratio'?");
  EXPECT_EQ(why_no_check_code("unicorn"), "no code is called 'unicorn'");
}

}  // namespace
}  // namespace meshalyzer
