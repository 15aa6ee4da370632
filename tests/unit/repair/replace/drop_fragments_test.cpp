#include "meshalyzer/repair/fix_defects.h"
#include "support/shapes.h"
#include "unit/repair/repaired_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace meshalyzer {
namespace {

/// Adds a face at the first edge of the first face, which becomes its third.
///
/// @param way  From the middle of the edge to its tip.
Soup with_fin(Soup soup, const Vec3& way) {
  const Triangle t = soup.triangles.front();
  const Vec3 middle = (soup.positions[t[0]] + soup.positions[t[1]]) / 2.0;
  const auto tip = static_cast<Index>(soup.n_vertices());
  soup.positions.push_back(middle + way);
  soup.triangles.push_back({t[0], t[1], tip});
  return soup;
}

/// Away from a cube, at any edge of the first face.
const Vec3 kOut = {0, 0, -1};

std::size_t n_faces_after_repair(const Soup& soup) {
  return only_mesh(fix_defects(soup, {})).n_faces();
}

TEST(DropFragments, SmallFinOfASolidGoesAndIsNamed) {
  const RepairResult result = fix_defects(with_fin(shapes::cube(2), 0.05 * kOut), {});
  EXPECT_EQ(only_mesh(result).n_faces(), 12U);
  EXPECT_TRUE(is_good(only_mesh(result)));
  EXPECT_TRUE(is_noted(result, "a fragment of area 0.0"));
}

TEST(DropFragments, LargeFinStays) {
  EXPECT_EQ(n_faces_after_repair(with_fin(shapes::cube(2), 0.5 * kOut)), 13U);
}

TEST(DropFragments, FinOfASheetStays) {
  const Soup sheet = shapes::grid(20, 20);
  EXPECT_EQ(n_faces_after_repair(with_fin(sheet, {0, 0, 0.05})), sheet.n_faces() + 1);
}

TEST(DropFragments, FinStaysWhereHolesAreNotToBeFixed) {
  RepairOptions options;
  options.fixes.erase(DefectCode::Hole);
  const RepairResult result = fix_defects(with_fin(shapes::cube(2), 0.05 * kOut), options);
  EXPECT_EQ(only_mesh(result).n_faces(), 13U);
}

TEST(DropFragments, LoneFaceBesideASolidStays) {
  const Soup face = shapes::make({{3, 0, 0}, {3.1, 0, 0}, {3, 0.1, 0}}, {{0, 1, 2}});
  EXPECT_EQ(n_faces_after_repair(shapes::merged(shapes::cube(2), face)), 13U);
}

/// Takes away the faces round the first face, but for those at its first corner, by which it hangs
/// then.
Soup with_hanging_face(const Soup& soup) {
  const Triangle& first = soup.triangles.front();
  std::vector<Index> faces;
  for (Index face = 1; face < soup.n_faces(); ++face) {
    const Triangle& t = soup.triangles[face];
    const bool is_near =
        std::any_of(t.begin(), t.end(), [&](Index v) { return v == first[1] || v == first[2]; });
    if (is_near) faces.push_back(face);
  }
  return shapes::without_faces(soup, faces);
}

TEST(DropFragments, FaceThatHangsInAHoleGoes) {
  const RepairResult result = fix_defects(with_hanging_face(shapes::icosphere(3)), {});
  EXPECT_TRUE(is_good(only_mesh(result)));
  EXPECT_TRUE(is_noted(result, "with face 1"));
}

TEST(DropFragments, FaceThatHangsOnASheetStays) {
  const Soup sheet = with_hanging_face(shapes::grid(20, 20));
  EXPECT_EQ(n_faces_after_repair(sheet), sheet.n_faces());
}

}  // namespace
}  // namespace meshalyzer
