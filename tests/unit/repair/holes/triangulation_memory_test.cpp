#include "meshalyzer/repair/holes/internal/triangulation_memory.h"

#include "meshalyzer/repair/holes/internal/triangulate_loop.h"
#include "unit/repair/holes/hole_cases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

constexpr Index kCornersOfLoop = 40;

/// A wavy loop of vertices that are numbered from some number on, backwards.
class WavyLoop {
 public:
  explicit WavyLoop(Index first_vertex = 0) : existing_(mesh_, {}) {
    std::mt19937 random(7);
    for (Index i = 0; i < kCornersOfLoop; ++i) {
      const double a = 2.0 * std::numbers::pi * i / kCornersOfLoop;
      polygon_.points.emplace_back(std::cos(a), std::sin(a), below(random, 1000) / 1000.0);
      polygon_.vertices.push_back(first_vertex + kCornersOfLoop - 1 - i);
    }
    polygon_.normals.assign(kCornersOfLoop, Vec3::Zero());
    rules.existing = &existing_;
  }

  [[nodiscard]] const LoopPolygon& polygon() const { return polygon_; }

  /// Compares what is remembered with what is found anew.
  void expect_same(TriangulationMemory& memory) const {
    const auto expected = triangulate_loop(polygon_, rules);
    EXPECT_EQ(memory.triangulate(polygon_, rules), expected);
    EXPECT_EQ(memory.triangulate(polygon_, rules), expected);
  }

  LoopRules rules;

 private:
  Soup soup_;
  PreparedMesh mesh_{soup_};
  ExistingEdges existing_;
  LoopPolygon polygon_;
};

TEST(TriangulationMemory, TellsLoopsThatDifferApart) {
  TriangulationMemory memory;
  WavyLoop loop;
  loop.expect_same(memory);
  loop.rules.weight = LoopWeight::Area;
  loop.expect_same(memory);
  EXPECT_EQ(memory.n_known(), 2U);

  const auto first = triangulate_loop(loop.polygon(), loop.rules);
  ASSERT_TRUE(first);
  loop.rules.forbid({first->front()});
  loop.expect_same(memory);
  const Triangle& t = first->back();
  loop.rules.bridges = {{t[0], t[2]}};
  loop.expect_same(memory);
  EXPECT_EQ(memory.n_known(), 4U);
}

TEST(TriangulationMemory, KnowsALoopByOtherNumbersOfItsVertices) {
  TriangulationMemory memory;
  for (const Index first : {0U, 100U}) {
    WavyLoop loop(first);
    // Two triangles whose order is another one by the numbers of the corners.
    loop.rules.forbid({{first + 1, first + 2, first + 3}, {first + 20, first + 5, first + 9}});
    loop.expect_same(memory);
  }
  EXPECT_EQ(memory.n_known(), 1U);
}

TEST(TriangulationMemory, RemembersThatThereIsNoTriangulation) {
  TriangulationMemory memory;
  WavyLoop loop;
  for (Index i = 0; i < kCornersOfLoop; ++i) {
    for (Index k = 0; k < i; ++k) loop.rules.bridges.push_back({k, i});
  }
  EXPECT_FALSE(triangulate_loop(loop.polygon(), loop.rules));
  loop.expect_same(memory);
  EXPECT_EQ(memory.n_known(), 1U);
}

}  // namespace
}  // namespace meshalyzer
