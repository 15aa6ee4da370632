#include "meshalyzer/repair/split/internal/pair_round_edge.h"

#include "meshalyzer/base/types.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace meshalyzer {
namespace {

constexpr auto kBegins = Crossing::Against;
constexpr auto kEnds = Crossing::Along;

const Vec3 kBottom(0, 0, 0);
const Vec3 kTop(0, 0, 1);

/// A face at the edge from kBottom to kTop, at so many degrees round it, seen from above. Seen so,
/// a face that crosses upwards has its normal on the side of growing angles: material ends there.
FaceAtEdge face_at(double degrees, Crossing crossing, Index component = kNoIndex,
                   double border_share = 0.0) {
  const double angle = degrees * std::numbers::pi / 180;
  return {.apex = {std::cos(angle), std::sin(angle), 0.5},
          .crossing = crossing,
          .component = component,
          .border_share = border_share};
}

std::vector<Index> partners(const std::vector<FaceAtEdge>& faces) {
  return pair_round_edge(kBottom, kTop, faces).partner;
}

TEST(PairRoundEdge, FacesOfTwoSolidsAreJoinedAcrossTheMaterial) {
  // Material from 10 to 80 and from 200 to 330 degrees.
  const EdgePairing pairing =
      pair_round_edge(kBottom, kTop,
                      std::vector{face_at(330, kEnds), face_at(10, kBegins), face_at(200, kBegins),
                                  face_at(80, kEnds)});
  EXPECT_EQ(pairing.partner, (std::vector<Index>{2, 3, 0, 1}));
  EXPECT_TRUE(pairing.alternates);
}

TEST(PairRoundEdge, MaterialMayReachAcrossTheFirstFace) {
  // The same solids as if turned: one from 330 round to 60, the other from 100 to 300.
  EXPECT_EQ(partners({face_at(60, kEnds), face_at(100, kBegins), face_at(300, kEnds),
                      face_at(330, kBegins)}),
            (std::vector<Index>{3, 2, 1, 0}));
}

TEST(PairRoundEdge, TheEdgeTurnedRoundChangesNothing) {
  std::vector<FaceAtEdge> faces{face_at(330, kEnds), face_at(10, kBegins), face_at(200, kBegins),
                                face_at(80, kEnds)};
  const std::vector<Index> expected = partners(faces);
  for (FaceAtEdge& face : faces) face.crossing = face.crossing == kEnds ? kBegins : kEnds;
  EXPECT_EQ(pair_round_edge(kTop, kBottom, faces).partner, expected);
}

TEST(PairRoundEdge, SolidsWithAWallInCommonAreJoinedEachForItself) {
  // One from 0 to 90, one from 90 to 180: the two faces at 90 lie on each other.
  EXPECT_EQ(partners({face_at(0, kBegins), face_at(90, kBegins), face_at(90, kEnds),
                      face_at(180, kEnds)}),
            (std::vector<Index>{2, 3, 0, 1}));
}

TEST(PairRoundEdge, SolidsThatTouchAllRoundAreJoinedEachForItself) {
  // One from 0 to 180, one from 180 to 360; in any order.
  std::vector<Index> order{0, 1, 2, 3};
  const std::vector<FaceAtEdge> faces{face_at(0, kBegins), face_at(180, kEnds),
                                      face_at(180, kBegins), face_at(0, kEnds)};
  do {
    std::vector<FaceAtEdge> given;
    for (const Index i : order) given.push_back(faces[i]);
    const EdgePairing pairing = pair_round_edge(kBottom, kTop, given);
    EXPECT_TRUE(pairing.alternates);
    for (Index i = 0; i < 4; ++i) EXPECT_EQ(order[pairing.partner[i]], order[i] ^ 1U);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(PairRoundEdge, SolidsThatFillAllRoundAreJoinedEachForItself) {
  EXPECT_EQ(partners({face_at(90, kEnds), face_at(90, kBegins), face_at(250, kEnds),
                      face_at(250, kBegins), face_at(0, kEnds), face_at(0, kBegins)}),
            (std::vector<Index>{5, 2, 1, 4, 3, 0}));
}

TEST(PairRoundEdge, PillowOutsideASolidIsJoinedToItself) {
  // Material from 0 to 90; two faces back to back at 200, with nothing between them.
  EXPECT_EQ(partners({face_at(0, kBegins), face_at(200, kEnds), face_at(90, kEnds),
                      face_at(200, kBegins)}),
            (std::vector<Index>{2, 3, 0, 1}));
}

TEST(PairRoundEdge, SurfacesThatLieOnEachOtherAreToldApartByOrder) {
  // Everything twice: the first with the first.
  EXPECT_EQ(
      partners({face_at(0, kBegins), face_at(90, kEnds), face_at(0, kBegins), face_at(90, kEnds)}),
      (std::vector<Index>{1, 0, 3, 2}));
}

TEST(PairRoundEdge, OverlappingSolidsAreNested) {
  // 0 to 180 and 90 to 270: passing through each other would leave a crossing that nobody can part.
  const EdgePairing pairing =
      pair_round_edge(kBottom, kTop,
                      std::vector{face_at(0, kBegins, 0), face_at(90, kBegins, 1),
                                  face_at(180, kEnds, 0), face_at(270, kEnds, 1)});
  EXPECT_EQ(pairing.partner, (std::vector<Index>{3, 2, 1, 0}));
  EXPECT_FALSE(pairing.alternates);
}

TEST(PairRoundEdge, SolidThatIsTurnedInsideOutStaysWhole) {
  // Patch 0 has material from 0 to 90; component 1 should have some from 180 to 270.
  EXPECT_EQ(partners({face_at(0, kBegins, 0), face_at(180, kEnds, 1), face_at(90, kEnds, 0),
                      face_at(270, kBegins, 1)}),
            (std::vector<Index>{2, 3, 0, 1}));
}

TEST(PairRoundEdge, FinOnASolidIsCutOff) {
  // The solid hangs together elsewhere, though its face at 80 is farther from flat than the fin.
  for (const Crossing crossing : {kBegins, kEnds}) {
    EXPECT_EQ(
        partners({face_at(0, kBegins, 0), face_at(200, crossing, 1, 0.7), face_at(80, kEnds, 0)}),
        (std::vector<Index>{2, kNoIndex, 0}));
  }
}

TEST(PairRoundEdge, WallThroughASolidIsCutOffWhereItsSidesAreFlatter) {
  // Three components without borders; the outer ones go on at 170 degrees.
  for (const Crossing crossing : {kBegins, kEnds}) {
    EXPECT_EQ(partners({face_at(0, kBegins, 0), face_at(80, crossing, 1), face_at(170, kEnds, 2)}),
              (std::vector<Index>{2, kNoIndex, 0}));
  }
}

TEST(PairRoundEdge, RimIsCutOffThoughItGoesOnMoreEvenly) {
  // Top of a box at 0, its side at 90, and a rim all round at 180 that has a border.
  EXPECT_EQ(partners({face_at(0, kBegins, 0), face_at(90, kEnds, 1), face_at(180, kEnds, 2, 0.5)}),
            (std::vector<Index>{1, 0, kNoIndex}));
}

TEST(PairRoundEdge, FinBetweenTwoSolidsLeavesBothWhole) {
  EXPECT_EQ(partners({face_at(0, kBegins, 0), face_at(90, kEnds, 0), face_at(130, kEnds, 2, 1.0),
                      face_at(180, kBegins, 1), face_at(270, kEnds, 1)}),
            (std::vector<Index>{1, 0, kNoIndex, 4, 3}));
}

TEST(PairRoundEdge, FinsOnBothSidesAreNotJoinedThroughTheSurface) {
  EXPECT_EQ(partners({face_at(0, kBegins, 0), face_at(90, kBegins, 1, 1.0), face_at(180, kEnds, 0),
                      face_at(270, kEnds, 2, 1.0)}),
            (std::vector<Index>{2, kNoIndex, 0, kNoIndex}));
}

TEST(PairRoundEdge, OfFacesOrientedAlikeTheFlattestTwoAreJoined) {
  EXPECT_EQ(partners({face_at(0, kEnds), face_at(100, kEnds), face_at(175, kEnds)}),
            (std::vector<Index>{2, kNoIndex, 0}));
}

TEST(PairRoundEdge, FaceWithoutAngleIsLeftOver) {
  FaceAtEdge needle{.apex = {0, 0, 2}, .crossing = kEnds};
  EXPECT_EQ(partners({needle, face_at(0, kBegins), face_at(90, kEnds)}),
            (std::vector<Index>{kNoIndex, 2, 1}));
  EXPECT_EQ(partners({needle, face_at(0, kBegins)}), (std::vector<Index>{1, 0}));
}

TEST(PairRoundEdge, EdgeWithoutLengthIsPairedInOrder) {
  const EdgePairing pairing = pair_round_edge(
      kTop, kTop, std::vector{face_at(0, kBegins), face_at(90, kBegins), face_at(180, kEnds)});
  EXPECT_EQ(pairing.partner, (std::vector<Index>{2, kNoIndex, 0}));
  EXPECT_FALSE(pairing.alternates);
}

TEST(PairRoundEdge, ManyFacesThatDoNotAlternateAreNestedInNoTime) {
  // So many that begin material, then so many that end it: like brackets.
  constexpr Index kHalf = 20000;
  std::vector<FaceAtEdge> faces;
  for (Index i = 0; i < 2 * kHalf; ++i) {
    faces.push_back(face_at(i * 0.008, i < kHalf ? kBegins : kEnds));
  }
  const std::vector<Index> partner = partners(faces);
  for (Index i = 0; i < 2 * kHalf; ++i) ASSERT_EQ(partner[i], 2 * kHalf - 1 - i);
}

TEST(PairRoundEdge, FacesCloserThanRoundingAreSortedAllTheSame) {
  // Both lie on the far side of the first two by a single step of the last place.
  const double just_over = std::nextafter(1.0, 2.0);
  const auto at = [](double x, double y, Crossing crossing) {
    return FaceAtEdge{.apex = {x, y, 0.5}, .crossing = crossing};
  };
  // Round: 45 degrees begins, a little more ends, a little more begins, 180 ends.
  EXPECT_EQ(partners({at(1, std::nextafter(just_over, 2.0), kBegins), at(1, 1, kBegins),
                      at(-1, 0, kEnds), at(1, just_over, kEnds)}),
            (std::vector<Index>{2, 3, 0, 1}));
}

}  // namespace
}  // namespace meshalyzer
