#include "meshalyzer/mesh/side_table.h"

#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

TEST(SideTable, MeshFaceIsFoundWhetherFacesBeforeItWereRejectedOrNot) {
  Soup soup = shapes::cube();
  soup.triangles.insert(soup.triangles.begin() + 4, {0, 0, 1});
  const SideTable side = build(soup).side;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    if (f == 4) continue;
    EXPECT_EQ(side.mesh_face(f), f < 4 ? f : f - 1) << f;
  }
}

TEST(SideTable, MeshVerticesAreTheFileVertexAndItsCopies) {
  // Two cubes that have one vertex in common.
  Soup soup = shapes::merged(shapes::cube(), shapes::cube(1, {1, 1, 1}));
  Index common = kNoIndex;
  for (Index v = 0; v < 8; ++v) {
    if (soup.positions[v] == Vec3(1, 1, 1)) common = v;
  }
  for (Triangle& t : soup.triangles) {
    for (Index& v : t) {
      if (soup.positions[v] == Vec3(1, 1, 1)) v = common;
    }
  }
  const SideTable side = build(soup).side;
  EXPECT_EQ(side.mesh_vertices(common),
            (std::vector{VertexHandle(static_cast<int>(common)), VertexHandle(16)}));
  const Index other = common == 0 ? 1 : 0;
  EXPECT_EQ(side.mesh_vertices(other), std::vector{VertexHandle(static_cast<int>(other))});
}

}  // namespace
}  // namespace meshalyzer
