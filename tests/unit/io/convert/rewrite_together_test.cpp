#include "meshalyzer/io/convert/rewrite_together.h"

#include "meshalyzer/boolean/operands.h"
#include "meshalyzer/io/read.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace meshalyzer {
namespace {

/// Files, one behind the other, unchanged.
RewrittenFile together(const std::vector<std::pair<std::string, std::string>>& files,
                       Format format) {
  std::vector<Soup> soups;
  for (const auto& [name, bytes] : files) soups.push_back(parse_mesh(bytes, name));
  std::vector<ReadFile> read;
  for (std::size_t i = 0; i < files.size(); ++i) read.push_back({soups[i], files[i].second});
  const Soup all = concatenate(soups);
  EditedMesh mesh{all, all, {}, {}};
  for (Index v = 0; v < all.n_vertices(); ++v) {
    mesh.vertices.push_back({ElementOrigin::Relation::Same, v});
  }
  for (Index f = 0; f < all.n_faces(); ++f) {
    mesh.faces.push_back({ElementOrigin::Relation::Same, f});
  }
  return rewrite_together(mesh, read, format);
}

std::string text_of(const std::vector<AttributeCount>& counts) {
  std::string text;
  for (const AttributeCount& count : counts) text += attribute_text(count) + ";";
  return text;
}

TEST(RewriteTogether, EachFileSaysWhatIsOfItsOwnElements) {
  const RewrittenFile file =
      together({{"a.off",
                 "COFF\n# first\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n0 1 0 255 0 0 255\n"
                 "3 0 1 2\n"},
                {"b.obj",
                 "# second\nv 5 0 0\nv 6 0 0\nv 6 1 0\nv 5 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                 "g quad\nf 1/1 2/2 3/3 4/4\n"}},
               Format::Obj);
  EXPECT_EQ(file.bytes,
            "# first\n# second\nv 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nv 5 0 0\n"
            "v 6 0 0\nv 6 1 0\nv 5 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
            "f 1 2 3\ng quad\nf 4/1 5/2 6/3 7/4\n");
  EXPECT_EQ(text_of(file.lost), "");
}

TEST(RewriteTogether, WhatTheFormatCannotHoldIsLost) {
  const RewrittenFile file =
      together({{"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl oak\nf 1 2 3\n"},
                {"b.obj", "v 5 0 0\nv 6 0 0\nv 5 1 0\nusemtl ash\ng one\nf 1 2 3\n"}},
               Format::Mesh);
  EXPECT_EQ(file.bytes,
            "Vertex 1 0 0 0\nVertex 2 1 0 0\nVertex 3 0 1 0\nVertex 4 5 0 0\nVertex 5 6 0 0\n"
            "Vertex 6 5 1 0\nFace 1 1 2 3\nFace 2 4 5 6\n");
  EXPECT_EQ(text_of(file.lost), "2 materials;1 group;");
}

TEST(RewriteTogether, ReferencesOfOneFileAreNoneOfTheOther) {
  const std::string inria =
      "MeshVersionFormatted 1\nDimension 3\nVertices 3\n0 0 0 7\n1 0 0 7\n0 1 0 7\nTriangles 1\n"
      "1 2 3 9\nEnd\n";
  const RewrittenFile file =
      together({{"a.obj", "v 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\n"}, {"b.mesh", inria}}, Format::Ply);
  EXPECT_NE(file.bytes.find("5 1 0 0\n0 0 0 7\n"), std::string::npos) << file.bytes;
  EXPECT_NE(file.bytes.find("3 0 1 2 0\n3 3 4 5 9\n"), std::string::npos) << file.bytes;
}

}  // namespace
}  // namespace meshalyzer
