#pragma once

#include "meshalyzer/base/colour_map.h"
#include "meshalyzer/picture/field.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace meshalyzer {

/// Triangles to be drawn, flat arrays in single precision about Scene::centre.
struct DrawnSurface {
  /// 3 #V: x, y, z.
  std::vector<float> positions;
  /// 3 #V: unit normals of the file's vertices, weighted by angle; zero where there is none.
  std::vector<float> normals;
  /// 3 #F: indices of drawn vertices.
  std::vector<std::uint32_t> triangles;
  /// #V: the record of the soup that each vertex is, or stands for.
  std::vector<Index> vertices;
  /// #F: the record of the soup that each face is, or (decimated) comes from.
  std::vector<Index> faces;

  [[nodiscard]] std::size_t n_vertices() const { return vertices.size(); }
  [[nodiscard]] std::size_t n_faces() const { return faces.size(); }
};

/// A field where it is drawn.
struct DrawnField {
  FieldName name = FieldName::Gaussian;
  FieldPlace place = FieldPlace::Vertices;
  FieldKind kind = FieldKind::Magnitude;
  /// By vertex or face of Scene::detail, and of Scene::context; NaN where there is none.
  std::vector<float> detail;
  std::vector<float> context;
  ColourScale scale;
  /// The smallest and largest finite value of the whole mesh; 0 ... 0 where there is none.
  double min = 0.0;
  double max = 0.0;
};

/// What is lit up when a defect is chosen; coordinates about Scene::centre.
struct Highlight {
  /// Index into DefectReport::defects.
  std::size_t defect = 0;
  /// Faces of Scene::detail.
  std::vector<std::uint32_t> faces;
  /// 6 a segment.
  std::vector<float> segments;
  /// 3 a point.
  std::vector<float> points;
  /// Where to fly: the centre and radius of what is to be seen; radius > 0.
  std::array<float, 3> focus{};
  float radius = 1.0F;
  /// Whether more elements belong to it than are lit up.
  bool is_cut = false;
};

/// Segments that are drawn over the surface, 6 floats each.
struct SceneLines {
  std::vector<float> borders;
  std::vector<float> non_manifold_edges;
  std::vector<float> flipped_edges;
  /// Where faces meet: of each intersecting pair the segment, or the point as a segment of length
  /// 0.
  std::vector<float> intersections;
};

/// What is drawn of a mesh.
struct Scene {
  /// Of the bounding box of the corners of all faces that can be drawn (where there are none, of
  /// all vertices); drawn coordinates are relative to it.
  Vec3 centre = Vec3::Zero();
  /// Half the diagonal of that box times scale; > 0.
  double radius = 1.0;
  /// Drawn coordinates are (p - centre) * scale: 1, but for tiny and huge meshes (half the box's
  /// longest side below 1/8 or from 2^18) a power of two that makes that half 1 ... 2.
  double scale = 1.0;
  /// Faces as they are: all, or those round the defects.
  DrawnSurface detail;
  /// The rest of the mesh, decimated; empty where detail is all.
  DrawnSurface context;
  std::vector<DrawnField> fields;
  std::vector<Highlight> highlights;
  SceneLines lines;
  /// Faces of the file that can be drawn (all corners there and finite).
  std::size_t n_faces = 0;
  /// Faces of the file that the context stands for.
  std::size_t n_decimated = 0;
  /// Sentences for the reader about what is not shown in full; empty where all is.
  std::vector<std::string> notes;
};

/// How much is drawn.
struct SceneLimits {
  /// Above so many faces a mesh is not drawn as it is.
  std::size_t max_whole_faces = 250'000;
  /// Then at most so many are, round the defects ...
  std::size_t max_detail_faces = 100'000;
  /// ... and the rest is decimated to about so many.
  std::size_t max_context_faces = 100'000;
  /// Listed and lit up, of each code.
  std::size_t max_defects_of_a_code = 500;
  /// Of one defect: faces, segments and points, each.
  std::size_t max_elements_of_a_defect = 2'000;
  /// Of all defects together; those that have more than their share are cut, all to the same size.
  std::size_t max_elements_of_all = 100'000;
  /// Of each of SceneLines.
  std::size_t max_segments = 200'000;
};

/// Makes what is drawn of a mesh.
///
/// Degenerate and zero-area faces are drawn too, if only as lines. Small meshes are drawn as they
/// are. Of larger ones the faces round the defects (breadth first, the same number of rings for
/// all, as far as the limit goes), the rest decimated by vertex clustering (Rossignac and Borrel
/// 1993, "Multi-resolution 3D approximations for rendering complex scenes").
///
/// @param source  With its defects.
/// @param names   The fields to draw.
/// @complexity    O(#V + #F) and the size of the defects.
[[nodiscard]] Scene make_scene(const FieldSource& source, const std::vector<FieldName>& names,
                               const SceneLimits& limits = {});

}  // namespace meshalyzer
