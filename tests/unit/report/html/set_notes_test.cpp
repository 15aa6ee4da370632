#include "meshalyzer/report/html/set_notes.h"

#include "sample_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SetNotes, MeshIsToldWhatItMeetsAndWhatItIsIn) {
  EXPECT_THAT(set_notes(sample_set()),
              ElementsAre(ElementsAre("intersects b.mesh, c.off", "partly inside c.off"),
                          ElementsAre("intersects a.mesh, c.off", "partly inside c.off"),
                          ElementsAre("intersects a.mesh, b.mesh", "inside a.mesh"), IsEmpty()));
}

TEST(SetNotes, NothingIsToldWhereItWasNotAskedFor) {
  SetAnalysis set = sample_set();
  set.intersections.reset();
  EXPECT_THAT(set_notes(set), ElementsAre(IsEmpty(), IsEmpty(), IsEmpty(), IsEmpty()));
}

TEST(SetNotes, LongListIsCut) {
  SetAnalysis set;
  set.names.assign(15, "m");
  set.intersections.emplace();
  for (Index other = 1; other < 15; ++other) {
    set.intersections->pairs.push_back({0, 1, other, 1, ContactKind::Crossing});
  }
  EXPECT_THAT(set_notes(set)[0],
              ElementsAre("intersects m, m, m, m, m, m, m, m, m, m, m, m and 2 more"));
}

}  // namespace
}  // namespace meshalyzer
