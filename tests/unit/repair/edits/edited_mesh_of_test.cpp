#include "meshalyzer/repair/edits/edited_mesh_of.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

using Relation = ElementOrigin::Relation;

/// A cap, whose third corner is almost on its longest edge, and the face beyond that edge.
Soup cap_and_face() {
  Soup soup;
  soup.format = Format::Obj;
  soup.positions = {{0, 0, 0}, {2, 0, 0}, {1, 1e-9, 0}, {1, -1, 0}};
  soup.triangles = {{0, 1, 2}, {1, 0, 3}};
  return soup;
}

TEST(EditedMeshOf, UntouchedElementsAreTheSame) {
  const Soup input = cap_and_face();
  const TrackedMesh tracked = track_mesh(input);
  for (const ElementOrigin& origin : edited_mesh_of(tracked, input).faces) {
    EXPECT_EQ(origin.relation, Relation::Same);
  }
}

TEST(EditedMeshOf, BothFacesOfAFlippedCapAreMadeOfTheFaceBeyondIt) {
  const Soup input = cap_and_face();
  TrackedMesh tracked = track_mesh(input);
  tracked.soup.triangles = {{2, 0, 3}, {2, 3, 1}};
  const EditedMesh mesh = edited_mesh_of(tracked, input);
  EXPECT_EQ(mesh.faces[0].relation, Relation::MadeOf);
  EXPECT_EQ(mesh.faces[0].record, 1u);
  EXPECT_EQ(mesh.faces[1].relation, Relation::Same);
  EXPECT_EQ(mesh.faces[1].record, 1u);
  EXPECT_EQ(mesh.left_places, std::vector<Index>{0});
}

TEST(EditedMeshOf, FaceThatKeepsItsPlaceIsTheSameWhicheverVertexIsNew) {
  Soup input = cap_and_face();
  input.positions[2].y() = 1;
  TrackedMesh tracked = track_mesh(input);
  // A weld: the corner is another vertex, at the same place.
  tracked.soup.positions.emplace_back(1, 1, 0);
  tracked.vertex_keys.push_back(4);
  tracked.vertex_origins.push_back(kNoIndex);
  tracked.soup.triangles[0][2] = 4;
  EXPECT_EQ(edited_mesh_of(tracked, input).faces[0].relation, Relation::Same);
}

}  // namespace
}  // namespace meshalyzer
