#include "meshalyzer/defects/defect_list.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <tuple>

namespace meshalyzer {
namespace {

/// A defect all of whose members have a value of their own.
Defect full_defect() {
  Defect defect;
  defect.code = DefectCode::Numbering;
  defect.severity = Severity::Warning;
  defect.vertices = {3, 1, kNoIndex - 1};
  defect.edges = {{4, 2}, {2, 9}};
  defect.faces = {7};
  defect.positions = {{0.1, -0.0, 1e300}, {1, 2, std::numeric_limits<double>::infinity()}};
  defect.pairs = {{1, 2, ContactKind::Crossing}, {1, 5, ContactKind::Unwelded}};
  defect.value = 0.25;
  defect.limit = 1e-300;
  defect.line = std::size_t{1} << 40U;
  defect.detail = "line 12";
  defect.fixable = false;
  return defect;
}

/// Removes one of the members, by its number.
Defect without(Defect defect, int member) {
  switch (member) {
    case 0:
      defect.severity = Severity::Error;
      break;
    case 1:
      defect.vertices.clear();
      break;
    case 2:
      defect.edges.clear();
      break;
    case 3:
      defect.faces.clear();
      break;
    case 4:
      defect.positions.clear();
      break;
    case 5:
      defect.pairs.clear();
      break;
    case 6:
      defect.value.reset();
      break;
    case 7:
      defect.limit.reset();
      break;
    case 8:
      defect.line.reset();
      break;
    case 9:
      defect.detail.clear();
      break;
    default:
      defect.fixable = true;
      break;
  }
  return defect;
}

constexpr int kMembers = 11;

auto members(const Defect& d) {
  return std::tuple(d.code, d.severity, d.vertices, d.edges, d.faces, d.positions, d.pairs, d.value,
                    d.limit, d.line, d.detail, d.fixable);
}

Defect orphan(Index vertex) {
  Defect defect;
  defect.code = DefectCode::OrphanVertex;
  defect.vertices = {vertex};
  return defect;
}

TEST(DefectList, NewListIsEmpty) {
  const DefectList list;
  EXPECT_TRUE(list.empty());
  EXPECT_TRUE(list.begin() == list.end());
  EXPECT_THROW(static_cast<void>(list.at(0)), std::out_of_range);
}

TEST(DefectList, EveryMemberComesBackAndSoDoesItsAbsence) {
  DefectList list{full_defect()};
  for (int member = 0; member < kMembers; ++member) list.push_back(without(full_defect(), member));
  list.push_back(Defect());
  ASSERT_EQ(list.size(), kMembers + 2U);
  EXPECT_EQ(members(list[0]), members(full_defect()));
  for (int member = 0; member < kMembers; ++member) {
    EXPECT_EQ(members(list[static_cast<std::size_t>(member) + 1]),
              members(without(full_defect(), member)))
        << member;
  }
  EXPECT_EQ(members(list.back()), members(Defect()));
}

TEST(DefectList, CodeAndFixAreKnownWithoutTheRest) {
  const DefectList list{full_defect(), orphan(4)};
  EXPECT_EQ(list.code_of(0), DefectCode::Numbering);
  EXPECT_EQ(list.code_of(1), DefectCode::OrphanVertex);
  EXPECT_FALSE(list.is_fixable(0));
  EXPECT_TRUE(list.is_fixable(1));
}

TEST(DefectList, LoopVisitsAllInOrder) {
  Index next = 0;
  for (const Defect& defect : DefectList{orphan(0), orphan(1), orphan(2)}) {
    EXPECT_EQ(defect.vertices, std::vector<Index>{next++});
  }
  EXPECT_EQ(next, 3U);
}

TEST(DefectList, AppendTakesTheFirstOfAnotherList) {
  DefectList list;
  list.append({orphan(0), full_defect()}, 2);
  list.append({orphan(1), full_defect(), orphan(2)}, 2);
  list.append({orphan(3)}, 0);
  ASSERT_EQ(list.size(), 4U);
  EXPECT_EQ(list[0].vertices, std::vector<Index>{0});
  EXPECT_EQ(list[2].vertices, std::vector<Index>{1});
  EXPECT_EQ(members(list[1]), members(full_defect()));
  EXPECT_EQ(members(list[3]), members(full_defect()));
}

TEST(DefectList, FirstOfAnotherListIsAllThatAnEmptyListTakes) {
  DefectList list;
  list.append({orphan(1), orphan(2)}, 1);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].vertices, std::vector<Index>{1});
}

}  // namespace
}  // namespace meshalyzer
