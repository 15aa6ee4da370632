#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/mesh/validate.h"
#include "support/random_soups.h"
#include "support/shapes.h"
#include "support/soups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::uint32_t kSeeds = 3000;

/// Any faces whatever over few vertices: nearly every edge is non-manifold, many faces come more
/// than once, some are degenerate or name a missing vertex.
Soup random_garbage(std::uint32_t seed) {
  std::mt19937 random(seed);
  const Index n_vertices = 3 + below(random, 6);
  const Index n_faces = below(random, 41);
  std::vector<Triangle> triangles;
  for (Index f = 0; f < n_faces; ++f) {
    Triangle t{};
    for (Index& v : t) v = below(random, 30) == 0 ? kNoIndex : below(random, n_vertices);
    triangles.push_back(t);
  }
  return soup_of(n_vertices, std::move(triangles));
}

/// A closed surface that has lost some faces and had others turned over or given twice.
Soup random_damage(std::uint32_t seed) {
  std::mt19937 random(seed);
  const std::vector<Soup> surfaces{shapes::icosphere(1), shapes::torus(2, 1, 4, 5),
                                   shapes::klein_bottle(4, 4), shapes::projective_plane(),
                                   shapes::two_tetrahedra_sharing_edge()};
  Soup soup = surfaces[below(random, static_cast<Index>(surfaces.size()))];
  const Index rarity = 2 + below(random, 30);
  return damaged(std::move(soup), rarity, random);
}

/// A cut mesh without its numbering: each fan by file vertex and faces, each cut edge by vertices
/// and faces.
struct Canonical {
  std::multiset<std::pair<Index, std::vector<Index>>> fans;
  std::multiset<std::vector<Index>> non_manifold_edges;
  std::multiset<std::vector<Index>> flipped_edges;
  std::vector<Index> non_manifold_vertices;

  friend bool operator==(const Canonical&, const Canonical&) = default;
};

std::multiset<std::vector<Index>> canonical_edges(const CutMesh& cut, const CutEdges& edges,
                                                  const std::vector<Index>& face_names) {
  std::multiset<std::vector<Index>> result;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const HalfedgeHandle first = edges[i].halfedges[0];
    const auto [a, b] = std::minmax({cut.side.vertex(cut.mesh.from_vertex_handle(first)),
                                     cut.side.vertex(cut.mesh.to_vertex_handle(first))});
    std::vector<Index> edge;
    for (const HalfedgeHandle h : edges[i].halfedges) {
      edge.push_back(face_names[cut.side.face(cut.mesh.face_handle(h))]);
    }
    std::sort(edge.begin(), edge.end());
    edge.insert(edge.begin(), {a, b});
    result.insert(std::move(edge));
  }
  return result;
}

/// @param face_names  What to call each of the file's faces.
Canonical canonical(const CutMesh& cut, const std::vector<Index>& face_names) {
  Canonical result;
  for (const VertexHandle v : cut.mesh.vertices()) {
    std::vector<Index> faces;
    for (const FaceHandle f : cut.mesh.vf_range(v)) faces.push_back(face_names[cut.side.face(f)]);
    std::sort(faces.begin(), faces.end());
    result.fans.emplace(cut.side.vertex(v), std::move(faces));
  }
  result.non_manifold_edges = canonical_edges(cut, cut.side.non_manifold_edges, face_names);
  result.flipped_edges = canonical_edges(cut, cut.side.flipped_edges, face_names);
  result.non_manifold_vertices = cut.side.non_manifold_vertices;
  return result;
}

/// Expects that build() holds its promises on this soup, and on the same faces in another order.
void expect_sound(const Soup& soup, std::uint32_t seed) {
  const CutMesh cut = build(soup);
  EXPECT_EQ(validate(cut, soup), std::vector<std::string>{});

  std::vector<Index> own_names(soup.n_faces());
  for (Index f = 0; f < own_names.size(); ++f) own_names[f] = f;
  std::vector<Index> old_names = own_names;
  std::mt19937 random(seed);
  for (std::size_t n = old_names.size(); n > 1; --n) {
    std::swap(old_names[n - 1], old_names[below(random, static_cast<Index>(n))]);
  }
  Soup shuffled = soup;
  for (std::size_t f = 0; f < old_names.size(); ++f) {
    Triangle& t = shuffled.triangles[f];
    t = soup.triangles[old_names[f]];
    std::rotate(t.begin(), t.begin() + below(random, 3), t.end());
  }
  const CutMesh cut_shuffled = build(shuffled);
  EXPECT_EQ(validate(cut_shuffled, shuffled), std::vector<std::string>{});
  EXPECT_TRUE(canonical(cut_shuffled, old_names) == canonical(cut, own_names))
      << "depends on the order of the faces";
}

TEST(BuildProperty, AnyFacesWhateverAreHeldFaithfully) {
  for (std::uint32_t seed = 0; seed < kSeeds && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_sound(random_garbage(seed), seed);
  }
}

TEST(BuildProperty, DamagedSurfacesAreHeldFaithfully) {
  for (std::uint32_t seed = 0; seed < kSeeds && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_sound(random_damage(seed), seed);
  }
}

/// A torus of 80,000 faces, more than one chunk of a parallel loop takes, some of its faces turned
/// over.
Soup many_chunks() {
  std::vector<Index> turned;
  for (Index f = 0; f < 80000; f += 97) turned.push_back(f);
  return shapes::renumbered_vertices(shapes::flipped(shapes::torus(2, 1, 200, 200), turned), 7);
}

TEST(BuildProperty, SurfaceOfManyChunksIsHeldFaithfully) {
  const Soup soup = many_chunks();
  const CutMesh cut = build(soup);
  EXPECT_EQ(validate(cut, soup), std::vector<std::string>{});
  // No two of the turned faces, 0, 97, ..., 79,928, are neighbours: three flipped edges each.
  EXPECT_EQ(cut.side.flipped_edges.size(), 3U * 825U);
}

TEST(BuildProperty, NumberOfThreadsChangesNothing) {
  const Soup soup = many_chunks();
  const auto build_with = [&](std::size_t n_threads) {
    const ThreadLimit limit(n_threads);
    return build(soup);
  };
  const CutMesh one = build_with(1);
  const CutMesh four = build_with(4);
  ASSERT_EQ(one.mesh.n_halfedges(), four.mesh.n_halfedges());
  for (const HalfedgeHandle h : one.mesh.halfedges()) {
    ASSERT_EQ(one.mesh.next_halfedge_handle(h), four.mesh.next_halfedge_handle(h));
    ASSERT_EQ(one.mesh.to_vertex_handle(h), four.mesh.to_vertex_handle(h));
    ASSERT_EQ(one.mesh.face_handle(h), four.mesh.face_handle(h));
  }
  ASSERT_EQ(one.mesh.n_vertices(), four.mesh.n_vertices());
  for (const VertexHandle v : one.mesh.vertices()) {
    ASSERT_EQ(one.mesh.halfedge_handle(v), four.mesh.halfedge_handle(v));
  }
  EXPECT_EQ(one.side.copies, four.side.copies);
  EXPECT_EQ(one.side.flipped_edges.halfedges, four.side.flipped_edges.halfedges);
}

}  // namespace
}  // namespace meshalyzer
