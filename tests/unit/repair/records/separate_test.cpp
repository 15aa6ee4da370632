#include "meshalyzer/repair/records/separate.h"

#include "support/same_soup.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace meshalyzer {
namespace {

using Keys = std::vector<Index>;
using shapes::InnerShell;

Keys key_range(Index begin, Index end) {
  Keys keys(end - begin);
  std::iota(keys.begin(), keys.end(), begin);
  return keys;
}

/// A tetrahedron of 4 faces, then a cube of 12.
Soup small_then_large() {
  return shapes::merged(shapes::tetrahedron(), shapes::cube(1.0, {5, 0, 0}));
}

std::vector<Index> ids_of(const Ids& ids, std::size_t n) {
  std::vector<Index> list;
  for (Index i = 0; i < n; ++i) list.push_back(static_cast<Index>(ids.of(i)));
  return list;
}

TEST(Separate, TwoSolidsComeApartTheLargerFirst) {
  const Soup soup = small_then_large();
  const std::vector<TrackedMesh> parts = separate(track_mesh(soup));
  ASSERT_EQ(parts.size(), 2u);
  Soup cube = shapes::cube(1.0, {5, 0, 0});
  // The ids of the file: 5 ... 12 and 5 ... 16.
  cube.vertex_ids.first = 5;
  cube.face_ids.first = 5;
  EXPECT_TRUE(same_soup(parts[0].soup, cube));
  EXPECT_TRUE(same_soup(parts[1].soup, shapes::tetrahedron()));
}

TEST(Separate, ElementsKeepTheirKeys) {
  const std::vector<TrackedMesh> parts = separate(track_mesh(small_then_large()));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].vertex_keys, key_range(4, 12));
  EXPECT_EQ(parts[0].face_keys, key_range(4, 16));
  EXPECT_EQ(parts[1].vertex_keys, key_range(0, 4));
  EXPECT_EQ(parts[1].face_keys, key_range(0, 4));
  EXPECT_EQ(parts[1].n_input_vertices, 12u);
  EXPECT_EQ(parts[1].n_input_faces, 16u);
}

TEST(Separate, AddedElementsKnowTheirOriginsInTheirPart) {
  TrackedMesh tracked = track_mesh(small_then_large());
  // The last two faces of the cube were made of the faces 4 and of none, vertex 11 is a copy of 4.
  tracked.face_keys[14] = 16;
  tracked.face_keys[15] = 17;
  tracked.face_origins = {4, kNoIndex};
  tracked.vertex_keys[11] = 12;
  tracked.vertex_origins = {4};
  const std::vector<TrackedMesh> parts = separate(tracked);
  EXPECT_EQ(parts[0].origin_of_face(10), 4u);
  EXPECT_EQ(parts[0].origin_of_face(11), kNoIndex);
  EXPECT_EQ(parts[0].vertex_origins, Keys{4});
  EXPECT_EQ(parts[1].origin_of_face(3), 3u);
}

TEST(Separate, FacesThatAlternateInTheFileKeepTheirOrder) {
  const Soup soup =
      shapes::shuffled_faces(shapes::merged(shapes::cube(), shapes::cube(1.0, {0, 0, 3})), 7);
  const std::vector<TrackedMesh> parts = separate(track_mesh(soup));
  ASSERT_EQ(parts.size(), 2u);
  // Equal sizes: the one with face 0 is the first.
  EXPECT_EQ(parts[0].face_keys.front(), 0u);
  for (const TrackedMesh& part : parts) {
    ASSERT_EQ(part.soup.n_faces(), 12u);
    EXPECT_TRUE(std::is_sorted(part.face_keys.begin(), part.face_keys.end()));
    for (std::size_t f = 0; f < 12; ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Index v = part.soup.triangles[f][k];
        EXPECT_EQ(part.vertex_keys[v], soup.triangles[part.face_keys[f]][k]);
        EXPECT_EQ(part.soup.positions[v], soup.positions[part.vertex_keys[v]]);
        EXPECT_EQ(part.soup.face_ids.of(static_cast<Index>(f)), part.face_keys[f] + 1);
      }
    }
  }
}

TEST(Separate, CavityStaysAMeshOfItsOwn) {
  const std::vector<TrackedMesh> parts =
      separate(track_mesh(shapes::nested_cubes(InnerShell::Cavity)));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].face_keys, key_range(0, 12));
  EXPECT_EQ(parts[1].face_keys, key_range(12, 24));
}

TEST(Separate, SolidsThatShareAVertexStayTogether) {
  const Soup soup = shapes::two_tetrahedra_sharing_vertex();
  const std::vector<TrackedMesh> parts = separate(track_mesh(soup));
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_TRUE(same_soup(parts[0].soup, soup));
}

TEST(Separate, MeshOfOneComponentComesBackAsItIs) {
  Soup soup = shapes::cube();
  soup.positions.emplace_back(9, 9, 9);
  soup.groups = {{"empty", 0}, {"all", 0}};
  soup.vertex_lines.assign(9, 3);
  const std::vector<TrackedMesh> parts = separate(track_mesh(soup));
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_TRUE(same_soup(parts[0].soup, soup));
  EXPECT_EQ(parts[0].soup.vertex_lines, soup.vertex_lines);
}

TEST(Separate, MeshWithoutFacesComesBackAsItIs) {
  for (const Soup& soup : {Soup(), shapes::make({{1, 2, 3}}, {{0, 0, 0}})}) {
    const std::vector<TrackedMesh> parts = separate(track_mesh(soup));
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_TRUE(same_soup(parts[0].soup, soup));
  }
}

TEST(Separate, NamedIdsAreKept) {
  Soup soup = small_then_large();
  soup.vertex_ids.named = {7, 1, 30, 2, 90, 91, 92, 93, 94, 95, 96, 98};
  soup.face_ids.named = {4, 3, 2, 1, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22};
  const std::vector<TrackedMesh> parts = separate(track_mesh(soup));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(ids_of(parts[0].soup.vertex_ids, 8), (Keys{90, 91, 92, 93, 94, 95, 96, 98}));
  EXPECT_EQ(ids_of(parts[0].soup.face_ids, 12), key_range(11, 23));
  EXPECT_EQ(ids_of(parts[1].soup.vertex_ids, 4), (Keys{7, 1, 30, 2}));
  EXPECT_EQ(ids_of(parts[1].soup.face_ids, 4), (Keys{4, 3, 2, 1}));
}

TEST(Separate, FormatsThatNumberSilentlyGoOnDoingSo) {
  Soup soup = small_then_large();
  soup.format = Format::Obj;
  for (const TrackedMesh& part : separate(track_mesh(soup))) {
    EXPECT_EQ(part.soup.vertex_ids.of(0), 1);
    EXPECT_EQ(part.soup.face_ids.of(0), 1);
    EXPECT_TRUE(part.soup.vertex_ids.named.empty());
  }
}

TEST(Separate, FacesKeepTheirGroups) {
  Soup soup = small_then_large();
  soup.groups = {{"a", 1}, {"b", 3}, {"empty", 5}, {"c", 5}};
  const std::vector<TrackedMesh> parts = separate(track_mesh(soup));
  ASSERT_EQ(parts.size(), 2u);
  for (const TrackedMesh& part : parts) {
    for (Index f = 0; f < part.soup.n_faces(); ++f) {
      const Index now = group_of(part.soup, f);
      const Index before = group_of(soup, part.face_keys[f]);
      ASSERT_EQ(now == kNoIndex, before == kNoIndex);
      if (now != kNoIndex) {
        EXPECT_EQ(part.soup.groups[now].name, soup.groups[before].name);
      }
    }
  }
  EXPECT_EQ(parts[0].soup.groups.size(), 2u);
  EXPECT_EQ(parts[1].soup.groups.size(), 2u);
}

TEST(Separate, VerticesKeepTheirNormals) {
  Soup soup = small_then_large();
  for (const Vec3& p : soup.positions) soup.normals.push_back(p + Vec3(1, 1, 1));
  soup.corner_normals = soup.triangles;
  for (const TrackedMesh& part : separate(track_mesh(soup))) {
    ASSERT_EQ(part.soup.normals.size(), part.soup.n_vertices());
    EXPECT_EQ(part.soup.corner_normals, part.soup.triangles);
    for (std::size_t v = 0; v < part.soup.n_vertices(); ++v) {
      EXPECT_EQ(part.soup.normals[v], soup.normals[part.vertex_keys[v]]);
    }
  }
}

TEST(Separate, CornersKeepTheirNormals) {
  Soup soup = small_then_large();
  // One normal a face, in turn backwards, the faces 2 and 9 without.
  for (Index f = 0; f <= 16; ++f) soup.normals.emplace_back(1, f, 0);
  for (Index f = 0; f < 16; ++f) {
    const Index normal = f == 2 || f == 9 ? kNoIndex : 15 - f;
    soup.corner_normals.push_back({normal, normal, normal});
  }
  const std::vector<TrackedMesh> parts = separate(track_mesh(soup));
  ASSERT_EQ(parts.size(), 2u);
  for (const TrackedMesh& part : parts) {
    ASSERT_EQ(part.soup.corner_normals.size(), part.soup.n_faces());
    for (std::size_t f = 0; f < part.soup.n_faces(); ++f) {
      const Index now = part.soup.corner_normals[f][1];
      const Index before = soup.corner_normals[part.face_keys[f]][1];
      ASSERT_EQ(now == kNoIndex, before == kNoIndex);
      if (now != kNoIndex) {
        EXPECT_EQ(part.soup.normals[now], soup.normals[before]);
      }
    }
  }
  // 11 of the cube's faces have one; 6, 13 and 16, which are used by none, stay with the first.
  EXPECT_EQ(parts[0].soup.normals.size(), 14u);
  EXPECT_EQ(parts[1].soup.normals.size(), 3u);
}

TEST(Separate, OrphansStayWithTheFirst) {
  Soup soup = small_then_large();
  soup.positions.insert(soup.positions.begin() + 4, Vec3(9, 9, 9));
  for (std::size_t f = 4; f < 16; ++f) {
    for (Index& v : soup.triangles[f]) ++v;
  }
  const std::vector<TrackedMesh> parts = separate(track_mesh(soup));
  EXPECT_EQ(parts[0].vertex_keys, key_range(4, 13));
  EXPECT_EQ(parts[1].vertex_keys, key_range(0, 4));
}

TEST(Separate, BrokenFacesGoWithTheirVertices) {
  Soup soup = small_then_large();
  soup.positions.emplace_back(9, 9, 9);
  soup.triangles.push_back({1, 1, 2});          // of the tetrahedron
  soup.triangles.push_back({kNoIndex, 2, 12});  // too, and of a vertex in no component
  soup.triangles.push_back({12, 12, 12});       // of nothing
  soup.missing = {{.face = 17, .corner = 0, .id = 77}};
  const std::vector<TrackedMesh> parts = separate(track_mesh(soup));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[1].face_keys, (Keys{0, 1, 2, 3, 16, 17}));
  EXPECT_EQ(parts[1].vertex_keys, (Keys{0, 1, 2, 3, 12}));
  ASSERT_EQ(parts[1].soup.missing.size(), 1u);
  EXPECT_EQ(parts[1].soup.missing[0].face, 5u);
  EXPECT_EQ(parts[1].soup.missing[0].id, 77);
  EXPECT_EQ(parts[1].soup.triangles[5], (Triangle{kNoIndex, 2, 4}));
  EXPECT_EQ(parts[0].face_keys.back(), 18u);
  EXPECT_EQ(parts[0].vertex_keys.back(), 12u);
  EXPECT_TRUE(parts[0].soup.missing.empty());
}

TEST(Separate, ManyPartsAreQuick) {
  Soup soup;
  for (Index i = 0; i < 20000; ++i) {
    for (int k = 0; k < 3; ++k) soup.positions.emplace_back(i, k, k * k);
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  EXPECT_EQ(separate(track_mesh(soup)).size(), 20000u);
}

}  // namespace
}  // namespace meshalyzer
