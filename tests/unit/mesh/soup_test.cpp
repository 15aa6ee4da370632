#include "meshalyzer/mesh/soup.h"

#include <gtest/gtest.h>

#include <vector>

namespace meshalyzer {
namespace {

TEST(IsInComplex, ThreeDifferentVerticesAre) {
  EXPECT_TRUE(is_in_complex({4, 0, 2}));
}

TEST(IsInComplex, AVertexNamedTwiceIsNotWhereverItStands) {
  EXPECT_FALSE(is_in_complex({1, 1, 2}));
  EXPECT_FALSE(is_in_complex({1, 2, 2}));
  EXPECT_FALSE(is_in_complex({1, 2, 1}));
}

TEST(IsInComplex, AMissingVertexIsNotWhereverItStands) {
  EXPECT_FALSE(is_in_complex({kNoIndex, 1, 2}));
  EXPECT_FALSE(is_in_complex({1, kNoIndex, 2}));
  EXPECT_FALSE(is_in_complex({1, 2, kNoIndex}));
}

TEST(CompactSoup, NumbersVerticesByFirstUseAndDropsTheOthers) {
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  const Soup soup = compact_soup(positions, {{4, 1, 3}, {3, 1, 0}});
  EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(soup.positions,
            (std::vector<Vec3>{positions[4], positions[1], positions[3], positions[0]}));
}

TEST(CompactSoup, HasNoVerticesWithoutTriangles) {
  EXPECT_EQ(compact_soup({{1, 2, 3}}, {}).n_vertices(), 0U);
}

TEST(Ids, SilentRecordsCountFromTheFirst) {
  const Ids ids{.first = 5, .named = {}};
  EXPECT_EQ(ids.of(0), 5);
  EXPECT_EQ(ids.of(7), 12);
}

TEST(Ids, NamedRecordsHaveTheirOwn) {
  const Ids ids{.first = 1, .named = {30, -2}};
  EXPECT_EQ(ids.of(0), 30);
  EXPECT_EQ(ids.of(1), -2);
}

TEST(FormatName, IsTheLowerCaseWordOfReports) {
  EXPECT_EQ(format_name(Format::Mesh), "mesh");
  EXPECT_EQ(format_name(Format::Inria), "inria");
  EXPECT_EQ(format_name(Format::Obj), "obj");
  EXPECT_EQ(format_name(Format::Off), "off");
  EXPECT_EQ(format_name(Format::Stl), "stl");
  EXPECT_EQ(format_name(Format::Ply), "ply");
}

}  // namespace
}  // namespace meshalyzer
