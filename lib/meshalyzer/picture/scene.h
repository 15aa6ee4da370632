#pragma once

#include "meshalyzer/base/colour_map.h"
#include "meshalyzer/picture/field.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace meshalyzer {

/// Triangles to be drawn: flat arrays in single precision, relative to Scene::centre.
struct DrawnSurface {
  /// 3 #V: x, y, z.
  std::vector<float> positions;
  /// 3 #V: the unit normal of each vertex of the file, weighted by angle; zero where it has none.
  std::vector<float> normals;
  /// 3 #F: indices of drawn vertices.
  std::vector<std::uint32_t> triangles;
  /// #V: the record of the soup that each vertex is or stands for.
  std::vector<Index> vertices;
  /// #F: the record of the soup that each face is or, where it was decimated, comes from.
  std::vector<Index> faces;

  [[nodiscard]] std::size_t n_vertices() const { return vertices.size(); }
  [[nodiscard]] std::size_t n_faces() const { return faces.size(); }
};

/// The values of a field at what is drawn.
struct DrawnField {
  FieldName name = FieldName::Gaussian;
  FieldPlace place = FieldPlace::Vertices;
  FieldKind kind = FieldKind::Magnitude;
  /// The value of each vertex or face of Scene::detail, and of Scene::context; NaN where it has
  /// none.
  std::vector<float> detail;
  std::vector<float> context;
  ColourScale scale;
  /// The smallest and largest finite value of the whole mesh; 0 ... 0 where there is none.
  double min = 0.0;
  double max = 0.0;
};

/// The elements that light up when a defect, or a change, is chosen. Coordinates are relative to
/// Scene::centre.
struct Highlight {
  /// The place of the defect in DefectReport::defects, or of the change in the list.
  std::size_t number = 0;
  /// Faces of Scene::detail.
  std::vector<std::uint32_t> faces;
  /// Six coordinates for each segment.
  std::vector<float> segments;
  /// Three coordinates for each point.
  std::vector<float> points;
  /// The centre and radius of what the viewer moves to; radius > 0.
  std::array<float, 3> focus{};
  float radius = 1.0F;
  /// Tells whether more elements belong to it than are lit up.
  bool is_cut = false;
};

/// Segments that are drawn over the surface, six coordinates each.
struct SceneLines {
  std::vector<float> borders;
  std::vector<float> non_manifold_edges;
  std::vector<float> flipped_edges;
  /// The segments along which the faces of each intersecting pair meet; a point is a segment of
  /// length 0.
  std::vector<float> intersections;
};

/// All that is drawn of a mesh.
struct Scene {
  /// The centre of the bounding box of all faces that can be drawn or, where there are none, of all
  /// vertices. Drawn coordinates are relative to it.
  Vec3 centre = Vec3::Zero();
  /// Half the diagonal of that box times scale; > 0.
  double radius = 1.0;
  /// Drawn coordinates are (p - centre) * scale: 1, but for tiny and huge meshes (half the box's
  /// longest side below 1/8 or from 2^18) a power of two that makes that half 1 ... 2.
  double scale = 1.0;
  /// The faces that are drawn as they are: all, or those round the defects.
  DrawnSurface detail;
  /// The rest of the mesh, decimated; empty where detail is all.
  DrawnSurface context;
  std::vector<DrawnField> fields;
  /// Those of defects.
  std::vector<Highlight> highlights;
  /// Those of changes, in their order: see light_changes().
  std::vector<Highlight> changes;
  SceneLines lines;
  /// The number of faces of the file that can be drawn: all corners are there and finite.
  std::size_t n_faces = 0;
  /// The number of faces of the file that the context stands for.
  std::size_t n_decimated = 0;
  /// Sentences for the reader about what is not shown in full; empty where all is.
  std::vector<std::string> notes;
};

/// Limits on how much is drawn.
struct SceneLimits {
  /// A mesh of more faces than this is not drawn as it is.
  std::size_t max_whole_faces = 250'000;
  /// The largest number of faces round the defects of such a mesh that are drawn as they are.
  std::size_t max_detail_faces = 100'000;
  /// The rest of such a mesh is decimated to about so many faces.
  std::size_t max_context_faces = 100'000;
  /// The largest number of defects of each code that are listed and lit up.
  std::size_t max_defects_of_a_code = 500;
  /// The largest number of faces, of segments and of points that are lit up for one defect.
  std::size_t max_elements_of_a_defect = 2'000;
  /// The largest number of elements of all defects together that are lit up. Defects that have more
  /// than their share are cut, all to the same size.
  std::size_t max_elements_of_all = 100'000;
  /// The largest number of segments that are drawn of each of SceneLines.
  std::size_t max_segments = 200'000;
};

/// Decides what is drawn of a mesh.
///
/// Degenerate and zero-area faces are drawn too, if only as lines. A small mesh is drawn as it is.
/// A larger one is drawn as it is round its defects (breadth first, the same number of rings round
/// all, as far as the limit goes), and the rest decimated by vertex clustering (Rossignac and
/// Borrel 1993, "Multi-resolution 3D approximations for rendering complex scenes").
///
/// @param source  The mesh and its defects.
/// @param names   The fields to draw.
/// @complexity    O(#V + #F) and the size of the defects.
[[nodiscard]] Scene make_scene(const FieldSource& source, const std::vector<FieldName>& names,
                               const SceneLimits& limits = {});

/// A place of a mesh that a repair has changed: faces of the soup, and edges by their vertices.
struct ChangedPlace {
  std::vector<Index> faces;
  std::vector<std::array<Index, 2>> edges;
};

/// Lights up the places that were changed, as far as their faces are drawn in detail.
///
/// @param scene  Of the soup; gets Scene::changes.
/// @complexity   O(#V + #F) and the size of the changes.
void light_changes(Scene& scene, const Soup& soup, std::span<const ChangedPlace> changes,
                   const SceneLimits& limits = {});

}  // namespace meshalyzer
