#include "meshalyzer/io/convert/count_attributes.h"

#include "meshalyzer/io/read.h"

#include <gtest/gtest.h>

#include <string>

namespace meshalyzer {
namespace {

std::string counted(const std::string& bytes, const std::string& name) {
  std::string text;
  for (const AttributeCount& count : count_attributes(parse_mesh(bytes, name), bytes)) {
    text += text.empty() ? "" : ", ";
    text += attribute_text(count);
  }
  return text;
}

TEST(CountAttributes, ObjCountsMaterialsAndGroupsByName) {
  EXPECT_EQ(counted("# c\nv 0 0 0 1 1 1\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nusemtl a\ng x\nf 1 2 3\n"
                    "usemtl b\nf 1 2 3\nusemtl a\nf 1 2 3 2\nl 1 2\n",
                    "a.obj"),
            "1 polygon, 2 texture coordinates, 1 vertex colour, 2 materials, 1 group, 1 line or "
            "point, 1 comment");
}

TEST(CountAttributes, PlyCountsPropertiesAndOtherElements) {
  EXPECT_EQ(counted("ply\nformat ascii 1.0\ncomment c\nelement vertex 3\nproperty float x\n"
                    "property float y\nproperty float z\nproperty uchar red\nproperty float s\n"
                    "element face 1\nproperty list uchar int vertex_index\nproperty int label\n"
                    "element edge 2\nproperty int vertex1\nend_header\n0 0 0 1 0\n1 0 0 1 0\n"
                    "0 1 0 1 0\n3 0 1 2 9\n0\n1\n",
                    "a.ply"),
            "3 texture coordinates, 3 vertex colours, 1 face property, 2 other records, 1 comment");
}

TEST(CountAttributes, ObjCountsWeightsThatAreNot1AsAProperty) {
  const std::string rest = "v 1 0 0 1 0 0 0\nv 0 1 0 1.0\nf 1 2 3\n";
  EXPECT_EQ(counted("v 0 0 0 0.5\n" + rest, "a.obj"), "1 vertex colour, 1 vertex property");
  EXPECT_EQ(counted("v 0 0 0 1\n" + rest, "a.obj"), "1 vertex colour");
}

TEST(CountAttributes, MarkOfACommentInsideANameBeginsNone) {
  EXPECT_EQ(counted("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a#1\ng b#2 # c\nf 1 2 3\n#\n", "a.obj"),
            "1 material, 1 group, 2 comments");
  EXPECT_EQ(counted("solid part#3\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0\n"
                    "vertex 0 1 0 endloop endfacet\nendsolid part#3\n",
                    "a.stl"),
            "1 group");
}

TEST(CountAttributes, PlyCountsPartsOfNormalsAndPropertiesOfStrips) {
  EXPECT_EQ(counted("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                    "property float y\nproperty float z\nproperty float nx\nproperty float ny\n"
                    "element tristrips 1\nproperty list int int vertex_indices\n"
                    "property int label\nend_header\n0 0 0 1 0\n1 0 0 1 0\n0 1 0 1 0\n"
                    "3 0 1 2 9\n",
                    "a.ply"),
            "2 vertex properties, 1 face property");
}

TEST(CountAttributes, OffCountsRecordsWithAColour) {
  EXPECT_EQ(
      counted("OFF\n4 2 0\n0 0 0 1 1 1\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2 255 0 0\n3 1 3 2\n", "a.off"),
      "1 vertex colour, 1 face colour");
}

TEST(CountAttributes, InriaCountsReferencesAndOtherSections) {
  EXPECT_EQ(counted("MeshVersionFormatted 2\nDimension 3\nVertices 3\n0 0 0 4\n1 0 0 0\n0 1 0 0\n"
                    "Triangles 1\n1 2 3 8\nEdges 1\n1 2 0\nEnd\n",
                    "a.mesh"),
            "2 references, 1 other record");
}

TEST(CountAttributes, InriaCountsStatementsWithoutACountOnce) {
  EXPECT_EQ(counted("MeshVersionFormatted 2\nDimension 3\nAngleOfCornerBound 45\n"
                    "BoundingBox 100 0 0 1 1 1\nGeometry \"a.geom\"\nVertices 3\n0 0 0 0\n1 0 0 0\n"
                    "0 1 0 0\nTriangles 1\n1 2 3 0\nEnd\nEdges 7\n",
                    "a.mesh"),
            "3 other records");
}

// A comment may begin where a number ends, but not within a name.
TEST(CountAttributes, CommentsAreThoseOfTheReader) {
  EXPECT_EQ(counted("v 0 0 0#c\nv 1 0 0 # c # c\nv 0 1 0\ng a#b\nf 1 2 3\n", "a.obj"),
            "1 group, 2 comments");
  EXPECT_EQ(counted("Vertex 1 0 0 0#c\n#c\n", "a.mesh"), "2 comments");
}

// The name behind endsolid is no solid, whatever its words are.
TEST(CountAttributes, AsciiStlCountsSolidsThatHaveAName) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\n";
  EXPECT_EQ(counted("solid small part\n" + facet + "endsolid small part\n", "a.stl"), "1 group");
  EXPECT_EQ(
      counted("solid\n" + facet + "endsolid\nSolid b#c\n" + facet + "EndSolid b#c\n", "a.stl"),
      "1 group");
}

}  // namespace
}  // namespace meshalyzer
