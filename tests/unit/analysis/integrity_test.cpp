#include "meshalyzer/analysis/internal/integrity.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace meshalyzer {
namespace {

using Records = std::vector<Index>;
using FileIds = std::vector<std::int64_t>;

/// The integrity of a soup and its offenders.
struct Checked {
  Integrity integrity;
  Offenders offenders;
};

Checked check(const Soup& soup) {
  Checked checked;
  checked.integrity = check_integrity(soup, checked.offenders);
  return checked;
}

/// The unit cube with its vertices called as given.
Soup cube_called(std::vector<std::int32_t> vertex_ids) {
  Soup soup = shapes::cube();
  soup.vertex_ids.named = std::move(vertex_ids);
  return soup;
}

/// Makes a corner name an id that no record defines.
void break_corner(Soup& soup, Index face, std::uint8_t corner, std::int64_t id) {
  soup.triangles[face][corner] = kNoIndex;
  soup.missing.push_back({face, corner, id});
}

TEST(CheckIntegrity, CleanFileHasNoFault) {
  const auto [integrity, offenders] = check(shapes::cube());
  EXPECT_EQ(integrity.orphan_vertices, 0U);
  EXPECT_EQ(integrity.missing_vertices, 0U);
  EXPECT_EQ(integrity.degenerate_faces, 0U);
  EXPECT_EQ(integrity.duplicate_vertex_indices, 0U);
  EXPECT_EQ(integrity.duplicate_face_indices, 0U);
  EXPECT_TRUE(integrity.contiguous_vertices);
  EXPECT_TRUE(integrity.contiguous_faces);
  EXPECT_FALSE(offenders.vertex_numbering.has_value());
}

TEST(CheckIntegrity, EmptyFileHasNoFault) {
  const Integrity integrity = check(Soup{}).integrity;
  EXPECT_EQ(integrity.orphan_vertices, 0U);
  EXPECT_TRUE(integrity.contiguous_vertices);
  EXPECT_TRUE(integrity.contiguous_faces);
}

TEST(CheckIntegrity, VerticesThatNoFaceUsesAreOrphans) {
  Soup soup = shapes::cube();
  soup.positions.insert(soup.positions.begin(), Vec3(9, 9, 9));
  for (Triangle& t : soup.triangles) {
    for (Index& corner : t) ++corner;
  }
  soup.positions.emplace_back(8, 8, 8);
  const Checked checked = check(soup);
  EXPECT_EQ(checked.integrity.orphan_vertices, 2U);
  EXPECT_EQ(checked.offenders.orphan_vertices, (Records{0, 9}));
}

TEST(CheckIntegrity, VertexOfADegenerateFaceIsNoOrphan) {
  EXPECT_EQ(check(shapes::make({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}})).integrity.orphan_vertices, 0U);
}

TEST(CheckIntegrity, RecordThatRepeatsAnIdIsNoOrphan) {
  Soup soup = cube_called({1, 2, 3, 4, 5, 6, 7, 8, 3});
  soup.positions.emplace_back(9, 9, 9);
  EXPECT_EQ(check(soup).integrity.orphan_vertices, 0U);
  EXPECT_EQ(check(soup).integrity.duplicate_vertex_indices, 1U);
}

TEST(CheckIntegrity, TornLinesAreCountedAndNamed) {
  Soup soup = shapes::cube();
  soup.torn_lines = {4, 17};
  EXPECT_EQ(check(soup).integrity.torn_lines, 2U);
  ASSERT_EQ(check(soup).offenders.torn_lines.size(), 2U);
  EXPECT_EQ(check(soup).offenders.torn_lines[1], 17U);
}

TEST(CheckIntegrity, MissingVerticesAreDistinctIds) {
  Soup soup = shapes::cube();
  break_corner(soup, 2, 1, 77);
  break_corner(soup, 5, 0, 12);
  break_corner(soup, 5, 2, 77);
  const Checked checked = check(soup);
  EXPECT_EQ(checked.integrity.missing_vertices, 2U);
  EXPECT_EQ(checked.offenders.missing_vertices, (FileIds{12, 77}));
  EXPECT_EQ(checked.offenders.faces_with_missing_vertices, (Records{2, 5}));
  EXPECT_EQ(checked.integrity.degenerate_faces, 0U);
}

TEST(CheckIntegrity, FaceThatNamesAVertexTwiceIsDegenerate) {
  Soup soup = shapes::cube();
  soup.triangles.insert(soup.triangles.end(), {{0, 1, 1}, {2, 3, 2}, {4, 4, 5}, {6, 6, 6}});
  const Checked checked = check(soup);
  EXPECT_EQ(checked.integrity.degenerate_faces, 4U);
  EXPECT_EQ(checked.offenders.degenerate_faces, (Records{12, 13, 14, 15}));
}

TEST(CheckIntegrity, FaceThatNamesAMissingVertexTwiceIsDegenerateToo) {
  Soup soup = shapes::cube();
  break_corner(soup, 3, 0, 50);
  break_corner(soup, 3, 2, 50);
  // Two missing vertices that are different.
  break_corner(soup, 4, 0, 50);
  break_corner(soup, 4, 1, 51);
  const Checked checked = check(soup);
  EXPECT_EQ(checked.offenders.degenerate_faces, Records{3});
  EXPECT_EQ(checked.offenders.faces_with_missing_vertices, (Records{3, 4}));
  EXPECT_EQ(checked.integrity.missing_vertices, 2U);
}

TEST(CheckIntegrity, FaceWithMissingVertexAndOneTwiceIsBoth) {
  Soup soup = shapes::make({{0, 0, 0}}, {{0, 0, 0}});
  break_corner(soup, 0, 1, 5);
  const Checked checked = check(soup);
  EXPECT_EQ(checked.offenders.degenerate_faces, Records{0});
  EXPECT_EQ(checked.offenders.faces_with_missing_vertices, Records{0});
}

TEST(CheckIntegrity, RecordsBeyondTheFirstOfAnIdAreDuplicates) {
  Soup soup = cube_called({1, 2, 3, 2, 5, 3, 2, 8});
  soup.face_ids.named = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 1};
  const Checked checked = check(soup);
  EXPECT_EQ(checked.integrity.duplicate_vertex_indices, 3U);
  EXPECT_EQ(checked.offenders.duplicate_vertex_records, (Records{3, 5, 6}));
  EXPECT_EQ(checked.integrity.duplicate_face_indices, 1U);
  EXPECT_EQ(checked.offenders.duplicate_face_records, Records{11});
}

TEST(CheckIntegrity, DuplicatesAreFoundFarApartAndOutOfOrder) {
  const Checked checked = check(cube_called({8, 1, 7, 2, 6, 3, 5, 8}));
  EXPECT_EQ(checked.offenders.duplicate_vertex_records, Records{7});
}

TEST(CheckIntegrity, NamedIdsInOrderAreContiguous) {
  EXPECT_TRUE(check(cube_called({1, 2, 3, 4, 5, 6, 7, 8})).integrity.contiguous_vertices);
}

TEST(CheckIntegrity, BreakInTheMiddleShowsTwoNeighboursOnEachSide) {
  const Checked checked = check(cube_called({1, 2, 3, 40, 5, 6, 7, 8}));
  EXPECT_FALSE(checked.integrity.contiguous_vertices);
  EXPECT_TRUE(checked.integrity.contiguous_faces);
  EXPECT_EQ(checked.offenders.vertex_numbering->ids, (FileIds{2, 3, 40, 5, 6}));
  EXPECT_EQ(checked.offenders.vertex_numbering->offender, 2U);
}

TEST(CheckIntegrity, BreakAtTheStartShowsWhatFollows) {
  const Checked first = check(cube_called({0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(first.offenders.vertex_numbering->ids, (FileIds{0, 1, 2}));
  EXPECT_EQ(first.offenders.vertex_numbering->offender, 0U);
  const Checked second = check(cube_called({1, 3, 2, 4, 5, 6, 7, 8}));
  EXPECT_EQ(second.offenders.vertex_numbering->ids, (FileIds{1, 3, 2, 4}));
  EXPECT_EQ(second.offenders.vertex_numbering->offender, 1U);
}

TEST(CheckIntegrity, BreakAtTheEndShowsWhatPrecedes) {
  const Checked last = check(cube_called({1, 2, 3, 4, 5, 6, 7, 10}));
  EXPECT_EQ(last.offenders.vertex_numbering->ids, (FileIds{6, 7, 10}));
  EXPECT_EQ(last.offenders.vertex_numbering->offender, 2U);
  const Checked second_to_last = check(cube_called({1, 2, 3, 4, 5, 6, 8, 7}));
  EXPECT_EQ(second_to_last.offenders.vertex_numbering->ids, (FileIds{5, 6, 8, 7}));
  EXPECT_EQ(second_to_last.offenders.vertex_numbering->offender, 2U);
}

TEST(CheckIntegrity, OnlyRecordOutOfPlaceIsShownAlone) {
  Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  soup.face_ids.named = {7};
  const Checked checked = check(soup);
  EXPECT_FALSE(checked.integrity.contiguous_faces);
  EXPECT_EQ(checked.offenders.face_numbering->ids, FileIds{7});
  EXPECT_EQ(checked.offenders.face_numbering->offender, 0U);
}

TEST(CheckIntegrity, FormatsThatNumberSilentlyCannotBreak) {
  Soup soup = shapes::cube();
  soup.format = Format::Off;
  soup.vertex_ids.first = soup.face_ids.first = 0;
  EXPECT_TRUE(check(soup).integrity.contiguous_vertices);
  EXPECT_TRUE(check(soup).integrity.contiguous_faces);
}

}  // namespace
}  // namespace meshalyzer
