#include "meshalyzer/set/object_meeting.h"

#include "cube_at.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <utility>
#include <vector>

namespace meshalyzer {

void PrintTo(Inclusion inclusion, std::ostream* out) {
  *out << (inclusion == Inclusion::None     ? "none"
           : inclusion == Inclusion::Partly ? "partly"
                                            : "wholly");
}

namespace {

ObjectMeeting meeting_of(const Soup& first, const Soup& second) {
  return find_meeting(SetObject(first), SetObject(second));
}

std::size_t count(const ObjectMeeting& meeting, ContactKind kind) {
  return static_cast<std::size_t>(
      std::count_if(meeting.pairs.begin(), meeting.pairs.end(),
                    [&](const IntersectingPair& pair) { return pair.kind == kind; }));
}

/// What the first object is to the second, which must not be in the first, both ways round.
Inclusion inclusion(const Soup& inner, const Soup& outer) {
  const ObjectMeeting meeting = meeting_of(inner, outer);
  const ObjectMeeting mirrored = meeting_of(outer, inner);
  EXPECT_EQ(meeting.second_in_first, Inclusion::None);
  EXPECT_EQ(mirrored.second_in_first, meeting.first_in_second);
  EXPECT_EQ(mirrored.first_in_second, meeting.second_in_first);
  std::vector<IntersectingPair> pairs = mirrored.pairs;
  for (IntersectingPair& pair : pairs) {
    std::swap(pair.face_a, pair.face_b);
  }
  std::sort(pairs.begin(), pairs.end(), [](const IntersectingPair& p, const IntersectingPair& q) {
    return std::pair(p.face_a, p.face_b) < std::pair(q.face_a, q.face_b);
  });
  EXPECT_EQ(pairs, meeting.pairs);
  return meeting.first_in_second;
}

TEST(FindMeeting, ObjectsApartHaveNothingToDoWithEachOther) {
  EXPECT_EQ(inclusion(cube_at(0, 1), cube_at(5, 1)), Inclusion::None);
  EXPECT_TRUE(meeting_of(cube_at(0, 1), cube_at(5, 1)).pairs.empty());
}

TEST(FindMeeting, ObjectInTheBoxButBesideTheSolidIsNotIncluded) {
  // The tetrahedron is x + y + z <= 1 in the unit cube, 0.6 + 0.6 + 0.6 is more.
  EXPECT_EQ(inclusion(cube_at(0.6, 0.2), shapes::tetrahedron()), Inclusion::None);
}

TEST(FindMeeting, ObjectInsideIsIncludedWholly) {
  EXPECT_EQ(inclusion(cube_at(1, 1), cube_at(0, 3)), Inclusion::Wholly);
  EXPECT_TRUE(meeting_of(cube_at(1, 1), cube_at(0, 3)).pairs.empty());
}

TEST(FindMeeting, OpenMeshInsideIsIncludedToo) {
  const Soup sheet = shapes::translated(shapes::grid(1, 1), Vec3::Ones());
  EXPECT_EQ(inclusion(sheet, cube_at(0, 3)), Inclusion::Wholly);
}

TEST(FindMeeting, OneComponentInsideIsIncludedPartly) {
  const Soup outer = cube_at(0, 4);
  EXPECT_EQ(inclusion(shapes::merged(cube_at(1, 1), cube_at(9, 1)), outer), Inclusion::Partly);
  EXPECT_EQ(inclusion(shapes::merged(cube_at(9, 1), cube_at(1, 1)), outer), Inclusion::Partly);
  EXPECT_EQ(inclusion(shapes::merged(cube_at(2.5, 1), cube_at(1, 1)), outer), Inclusion::Wholly);
}

TEST(FindMeeting, GuestInACavityIsNotIncluded) {
  const Soup host = shapes::nested_cubes(shapes::InnerShell::Cavity);
  EXPECT_EQ(inclusion(cube_at(1.25, 0.5), host), Inclusion::None);
  // In its wall it is.
  EXPECT_EQ(inclusion(cube_at(0.25, 0.5), host), Inclusion::Wholly);
  // It touches the cavity from within.
  EXPECT_EQ(inclusion(cube_at(1, 0.5), host), Inclusion::None);
}

TEST(FindMeeting, OpenMeshIncludesNothing) {
  EXPECT_EQ(inclusion(cube_at(0.25, 0.5), shapes::open_cube()), Inclusion::None);
  // Also where the other one stands on its floor.
  EXPECT_EQ(inclusion(shapes::cube(0.5, {0.25, 0.25, 0}), shapes::open_cube()), Inclusion::None);
}

TEST(FindMeeting, ObjectThatTouchesFromWithinIsIncludedWholly) {
  const ObjectMeeting meeting = meeting_of(cube_at(0, 1), cube_at(0, 3));
  EXPECT_EQ(inclusion(cube_at(0, 1), cube_at(0, 3)), Inclusion::Wholly);
  EXPECT_GT(count(meeting, ContactKind::CoplanarOverlap), 0U);
  EXPECT_EQ(count(meeting, ContactKind::Crossing), 0U);
}

TEST(FindMeeting, ObjectThatTouchesFromOutsideIsNotIncluded) {
  const Soup beside = shapes::cube(1.0, {3, 1, 1});
  EXPECT_EQ(inclusion(beside, cube_at(0, 3)), Inclusion::None);
  EXPECT_GT(count(meeting_of(beside, cube_at(0, 3)), ContactKind::CoplanarOverlap), 0U);
}

TEST(FindMeeting, ObjectInAndOutIsNotIncludedWhereItTouches) {
  // One in the wall, one that touches the cavity from within.
  const Soup both = shapes::merged(cube_at(0.25, 0.5), cube_at(1, 0.5));
  EXPECT_EQ(inclusion(both, shapes::nested_cubes(shapes::InnerShell::Cavity)), Inclusion::None);
}

TEST(FindMeeting, SameObjectTwiceIsNotIncludedInItself) {
  const ObjectMeeting meeting = meeting_of(cube_at(0, 1), cube_at(0, 1));
  EXPECT_EQ(inclusion(cube_at(0, 1), cube_at(0, 1)), Inclusion::None);
  EXPECT_EQ(count(meeting, ContactKind::Duplicate), 12U);
}

TEST(FindMeeting, ObjectsThatCrossDoNotIncludeEachOther) {
  const Soup outer = cube_at(0, 3);
  EXPECT_EQ(inclusion(cube_at(2, 2), outer), Inclusion::None);
  EXPECT_GT(count(meeting_of(cube_at(2, 2), outer), ContactKind::Crossing), 0U);
  // This holds even with another component inside.
  EXPECT_EQ(inclusion(shapes::merged(cube_at(2, 2), cube_at(0.5, 1)), outer), Inclusion::None);
}

TEST(FindMeeting, ObjectThatACavityCrossesIsNotIncluded) {
  // All its vertices are in the wall, but its top, z = 1.5, passes through the cavity [1, 2]^3.
  Soup slab = cube_at(0.5, 2);
  for (Vec3& p : slab.positions) {
    p.z() = std::min(p.z(), 1.5);
  }
  EXPECT_EQ(inclusion(slab, shapes::nested_cubes(shapes::InnerShell::Cavity)), Inclusion::None);
}

TEST(FindMeeting, PairsAreByFileFace) {
  // The corner (1, 1, 1) of the cube on the middle of a face, behind a record that is in no
  // complex.
  Soup floor = shapes::make({{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}, {{0, 0, 1}, {0, 1, 2}});
  const ObjectMeeting meeting = meeting_of(floor, shapes::cube(1.0, {0.5, 0.5, 1}));
  ASSERT_FALSE(meeting.pairs.empty());
  for (const IntersectingPair& pair : meeting.pairs) {
    EXPECT_EQ(pair.face_a, 1U);
  }
}

TEST(FindMeeting, MeshWithoutFacesMeetsNothing) {
  const ObjectMeeting meeting = meeting_of(Soup(), cube_at(0, 1));
  EXPECT_TRUE(meeting.pairs.empty());
  EXPECT_EQ(meeting.first_in_second, Inclusion::None);
  EXPECT_EQ(meeting.second_in_first, Inclusion::None);
}

}  // namespace
}  // namespace meshalyzer
