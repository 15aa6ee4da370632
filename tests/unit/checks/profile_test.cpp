#include "meshalyzer/checks/profile.h"

#include "meshalyzer/checks/check_mesh.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

bool passes(const Soup& soup, std::string_view profile) {
  return check_mesh(soup, "it", find_profile(profile)->criteria).is_good();
}

TEST(FindProfile, UnknownNameIsNone) {
  EXPECT_EQ(find_profile("art"), nullptr);
  EXPECT_EQ(check_profiles().front().name, "solid");
}

TEST(CheckProfiles, CubePassesAll) {
  for (const CheckProfile& profile : check_profiles()) {
    EXPECT_TRUE(passes(shapes::cube(), profile.name)) << profile.name;
  }
}

TEST(CheckProfiles, BordersAreMeantInSheetsAndExchange) {
  EXPECT_TRUE(passes(shapes::grid(3, 3), "sheet"));
  EXPECT_TRUE(passes(shapes::grid(3, 3), "exchange"));
  for (const std::string_view profile : {"solid", "print", "simulation"}) {
    EXPECT_FALSE(passes(shapes::grid(3, 3), profile)) << profile;
  }
}

TEST(CheckProfiles, IntersectionsPassOnlyInExchange) {
  const Soup crossing =
      shapes::merged(shapes::cube(), shapes::translated(shapes::cube(), Vec3(0.5, 0.25, 0.125)));
  EXPECT_TRUE(passes(crossing, "exchange"));
  for (const std::string_view profile : {"solid", "print", "simulation", "sheet"}) {
    EXPECT_FALSE(passes(crossing, profile)) << profile;
  }
}

// A plate of height 2^-10 has side faces of aspect ratio about 1024: a solid, but none to compute
// with.
TEST(CheckProfiles, SimulationAsksForRoundFaces) {
  Soup plate = shapes::cube();
  for (Vec3& p : plate.positions) p.z() /= 1024;
  EXPECT_TRUE(passes(plate, "solid"));
  EXPECT_TRUE(passes(plate, "print"));
  EXPECT_FALSE(passes(plate, "simulation"));
}

// 1e-9 of the diagonal is below the default tolerance, and not zero.
TEST(CheckProfiles, AllButDegenerateFacesPassOnlyWhereTheyAreSolid) {
  Soup plate = shapes::cube();
  for (Vec3& p : plate.positions) p.z() *= 1e-9;
  EXPECT_TRUE(passes(plate, "solid"));
  EXPECT_FALSE(passes(plate, "print"));
}

TEST(WhyNoProfile, MistypedNameIsFoundAndAllAreNamedForNonsense) {
  EXPECT_EQ(why_no_profile("print"), "");
  EXPECT_EQ(why_no_profile("prnt"), "no profile is called 'prnt'; did you mean 'print'?");
  EXPECT_EQ(why_no_profile("unicorn"),
            "no profile is called 'unicorn'; there are solid, print, simulation, sheet, exchange");
}

}  // namespace
}  // namespace meshalyzer
