#include "meshalyzer/set/edge_neighbourhood.h"

#include "direct_evaluation.h"
#include "meshalyzer/mesh/build.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

using Marks = std::vector<std::uint8_t>;

struct Mesh {
  explicit Mesh(const Soup& soup) : cut(build(soup)) {}

  Marks mark(Index vertex, double length) {
    const auto marked = neighbourhood.mark_within(vertex, length);
    return {marked.begin(), marked.end()};
  }

  CutMesh cut;
  FaceTree tree{cut};
  ItemsByGroup slots = slots_by_vertex(tree, cut.side.n_file_vertices);
  EdgeNeighbourhood neighbourhood{tree, slots};
};

/// The faces of the complex with a vertex within the length.
Marks direct_marks(const Soup& soup, const std::vector<double>& length_to, double length) {
  Marks marks;
  for (const Triangle& t : soup.triangles) {
    if (is_in_complex(t)) {
      marks.push_back(
          std::any_of(t.begin(), t.end(), [&](Index v) { return length_to[v] <= length; }) ? 1 : 0);
    }
  }
  return marks;
}

/// Tells whether sums in another order could be on the other side of a length.
bool is_close(const std::vector<double>& lengths, double length) {
  return std::any_of(lengths.begin(), lengths.end(),
                     [&](double x) { return std::abs(x - length) < 1e-9; });
}

TEST(MarkWithin, EqualsAllShortestWays) {
  std::mt19937 random(9);
  std::uniform_real_distribution<> real(0.0, 2.5);
  std::size_t n_checked = 0;
  for (const Soup& soup :
       {shapes::icosphere(2), shapes::grid(7, 5), shapes::torus(1, 0.3, 12, 6),
        shapes::merged(shapes::uv_sphere(5, 6), shapes::translated(shapes::cube(), {0.5, 0, 0})),
        damaged(shapes::torus(1, 0.4, 12, 8), 5, random), shapes::two_tetrahedra_sharing_edge()}) {
    Mesh mesh(soup);
    const auto lengths = test::path_lengths(soup);
    for (int i = 0; i < 200; ++i) {
      const Index vertex = below(random, static_cast<Index>(soup.n_vertices()));
      const double length = real(random);
      if (!is_close(lengths[vertex], length)) {
        EXPECT_EQ(mesh.mark(vertex, length), direct_marks(soup, lengths[vertex], length));
        ++n_checked;
      }
    }
  }
  EXPECT_GT(n_checked, 1000U);
}

TEST(MarkWithin, WithoutLengthOnlyTheFacesRoundTheVertexAreMarked) {
  const Soup soup = shapes::icosphere(1);
  Mesh mesh(soup);
  for (Index v = 0; v < soup.n_vertices(); ++v) {
    const Marks marks = mesh.mark(v, 0.0);
    for (std::size_t f = 0; f < soup.n_faces(); ++f) {
      const Triangle& t = soup.triangles[f];
      EXPECT_EQ(marks[f], std::count(t.begin(), t.end(), v));
    }
  }
}

TEST(MarkWithin, WayOfJustTheLengthLeadsThere) {
  // Along the border from the corner to the vertex (2, 0), 2 away, whose other faces are beyond it.
  const Soup soup = shapes::grid(4, 1);
  Mesh mesh(soup);
  const auto reaches_beyond = [&](double length) {
    const Marks marks = mesh.mark(0, length);
    for (std::size_t f = 0; f < soup.n_faces(); ++f) {
      double right = 0;
      for (const Index v : soup.triangles[f]) {
        right = std::max(right, soup.positions[v].x());
      }
      if (marks[f] != 0 && right == 3.0) {
        return true;
      }
    }
    return false;
  };
  EXPECT_TRUE(reaches_beyond(2.0));
  EXPECT_FALSE(reaches_beyond(1.99));
}

TEST(MarkWithin, OtherComponentIsNeverReached) {
  const Soup soup = shapes::merged(shapes::cube(), shapes::cube());
  Mesh mesh(soup);
  const Marks marks = mesh.mark(0, 1e300);
  EXPECT_EQ(std::count(marks.begin(), marks.end(), 1), 12);
}

TEST(SlotsByVertex, AreAllThatUseTheVertexAscending) {
  std::mt19937 random(2);
  const Soup soup = damaged(shapes::torus(1, 0.4, 12, 8), 4, random);
  const Mesh mesh(soup);
  ASSERT_EQ(mesh.slots.size(), soup.n_vertices());
  for (Index v = 0; v < soup.n_vertices(); ++v) {
    std::vector<Index> expected;
    for (std::size_t slot = 0; slot < mesh.tree.n_faces(); ++slot) {
      const Triangle& t = mesh.tree.triangle(slot);
      if (std::count(t.begin(), t.end(), v) != 0) {
        expected.push_back(static_cast<Index>(slot));
      }
    }
    const auto slots = mesh.slots[v];
    EXPECT_EQ(std::vector<Index>(slots.begin(), slots.end()), expected);
  }
}

}  // namespace
}  // namespace meshalyzer
