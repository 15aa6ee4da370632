#include "meshalyzer/report/html/repair_changes.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <map>

namespace meshalyzer {
namespace {

/// A repair, its report, and the files that came of it.
struct Repaired {
  explicit Repaired(Soup soup)
      : input(std::move(soup)),
        result(fix_defects(input)),
        report{.input = name_of(input, "in.mesh"),
               .result = result,
               .fixes = {},
               .meshes = {},
               .notes = {},
               .lost = {}} {
    for (const RepairedMesh& mesh : result.meshes) {
      finals.push_back(mesh.tracked.soup);
      report.meshes.push_back({.name = name_of(finals.back(), "out.mesh"), .remaining = {}});
    }
  }
  Repaired(const Repaired&) = delete;

  [[nodiscard]] RepairChanges changes() const {
    return find_changes(report, input, finals.front());
  }

  Soup input;
  RepairResult result;
  RepairReport report;
  std::vector<Soup> finals;
};

TEST(FindChanges, SeamOfTwoCubesIsTheHexagonAlongWhichTheyCross) {
  const Repaired cubes(shapes::merged(shapes::cube(), shapes::cube(1.0, {0.5, 0.5, 0.5})));
  const RepairChanges changes = cubes.changes();
  ASSERT_EQ(changes.before.places.size(), 1U);
  ASSERT_EQ(changes.after.places.size(), 1U);
  EXPECT_EQ(changes.before.changes.front().pass, "cut intersections");
  const ChangedPlace& after = changes.after.places.front();
  EXPECT_NE(changes.after.changes.front().text.find("a seam of"), std::string::npos);
  // Six sides of half an edge.
  const Soup& soup = cubes.finals.front();
  double length = 0.0;
  std::map<Index, int> degree;
  for (const auto& [a, b] : after.edges) {
    length += (soup.positions[a] - soup.positions[b]).norm();
    ++degree[a];
    ++degree[b];
  }
  EXPECT_NEAR(length, 3.0, 1e-12);
  for (const auto& [vertex, n] : degree) EXPECT_EQ(n, 2) << vertex;
}

TEST(FindChanges, WhatIsDroppedIsShownBeforeAlone) {
  Soup cube = shapes::cube();
  cube.triangles.push_back(cube.triangles.front());
  const RepairChanges changes = Repaired(cube).changes();
  ASSERT_EQ(changes.before.places.size(), 1U);
  EXPECT_EQ(changes.before.places.front().faces, std::vector<Index>{12});
  EXPECT_EQ(changes.before.changes.front().text, "face 13 dropped");
  EXPECT_TRUE(changes.after.places.empty());
}

TEST(FindChanges, PatchOfAHoleIsShownAfterAlone) {
  const RepairChanges changes = Repaired(shapes::open_cube()).changes();
  EXPECT_TRUE(changes.before.places.empty());
  ASSERT_EQ(changes.after.places.size(), 1U);
  EXPECT_EQ(changes.after.places.front().faces, (std::vector<Index>{10, 11}));
  EXPECT_TRUE(changes.after.places.front().edges.empty());
}

TEST(FindChanges, GoodMeshHasNone) {
  const RepairChanges changes = Repaired(shapes::torus(2, 1, 8, 8)).changes();
  EXPECT_TRUE(changes.before.places.empty());
  EXPECT_TRUE(changes.after.places.empty());
}

}  // namespace
}  // namespace meshalyzer
