#include "meshalyzer/mesh/inner_halfedge.h"

#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

TEST(InnerHalfedge, HasAFaceAndIsOfTheSameEdge) {
  const CutMesh cut = build(shapes::open_cube());
  for (const HalfedgeHandle h : cut.mesh.halfedges()) {
    const HalfedgeHandle inner = inner_halfedge(cut.mesh, h);
    EXPECT_FALSE(cut.mesh.is_boundary(inner));
    EXPECT_EQ(cut.mesh.edge_handle(inner), cut.mesh.edge_handle(h));
  }
}

TEST(InnerHalfedge, IsTheOneAskedForWhereThatHasAFace) {
  const CutMesh cut = build(shapes::cube());
  for (const HalfedgeHandle h : cut.mesh.halfedges()) EXPECT_EQ(inner_halfedge(cut.mesh, h), h);
  for (const EdgeHandle e : cut.mesh.edges()) {
    EXPECT_EQ(inner_halfedge(cut.mesh, e), cut.mesh.halfedge_handle(e, 0));
  }
}

}  // namespace
}  // namespace meshalyzer
