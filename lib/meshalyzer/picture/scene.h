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
  /// 3 #V: the angle-weighted unit normal of each vertex of the file; zero if it has none.
  std::vector<float> normals;
  /// 3 #F: indices of drawn vertices.
  std::vector<std::uint32_t> triangles;
  /// #V: the record of the soup that each vertex is or represents.
  std::vector<Index> vertices;
  /// #F: the record of the soup that each face is or, where it was decimated, comes from.
  std::vector<Index> faces;

  [[nodiscard]] std::size_t n_vertices() const { return vertices.size(); }
  [[nodiscard]] std::size_t n_faces() const { return faces.size(); }
};

/// The values of a field at the drawn elements.
struct DrawnField {
  FieldName name = FieldName::Gaussian;
  FieldPlace place = FieldPlace::Vertices;
  FieldKind kind = FieldKind::Magnitude;
  /// The value of each vertex or face of Scene::detail, NaN if it has none; likewise for
  /// Scene::context.
  std::vector<float> detail;
  std::vector<float> context;
  ColourScale scale;
  /// The smallest finite value of the whole mesh, like the largest; both are 0 if there is none.
  double min = 0.0;
  double max = 0.0;
};

/// The elements that are highlighted when a defect or change is chosen. Coordinates are relative to
/// Scene::centre.
struct Highlight {
  /// The position of the defect in DefectReport::defects, or of the change in the list.
  std::size_t number = 0;
  /// The faces, by index in Scene::detail.
  std::vector<std::uint32_t> faces;
  /// Six coordinates for each segment.
  std::vector<float> segments;
  /// Three coordinates for each point.
  std::vector<float> points;
  /// The centre of the view; its radius is positive.
  std::array<float, 3> focus{};
  float radius = 1.0F;
  /// Tells whether more elements belong to it than are highlighted.
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
  /// The centre of the bounding box of all faces that can be drawn or, if there are none, of all
  /// vertices. Drawn coordinates are relative to it.
  Vec3 centre = Vec3::Zero();
  /// Half the diagonal of that box times scale; > 0.
  double radius = 1.0;
  /// Drawn coordinates are (p - centre) * scale. The scale is 1, except for tiny and huge meshes
  /// (half the box's longest side below 1/8 or from 2^18), where it is the power of two that makes
  /// that half 1 ... 2.
  double scale = 1.0;
  /// The faces that are drawn in detail: all, or those round the defects.
  DrawnSurface detail;
  /// The rest of the mesh, decimated; empty if all is drawn in detail.
  DrawnSurface context;
  std::vector<DrawnField> fields;
  /// The highlights of defects.
  std::vector<Highlight> highlights;
  /// The highlights of changes, in their order: see highlight_changes().
  std::vector<Highlight> changes;
  SceneLines lines;
  /// The number of faces of the file that can be drawn, because all corners are defined and finite.
  std::size_t n_faces = 0;
  /// The number of faces of the file that the context represents.
  std::size_t n_decimated = 0;
  /// Sentences for the reader about omissions; empty if everything is shown.
  std::vector<std::string> notes;
};

/// The limits on the size of a scene.
struct SceneLimits {
  /// A mesh of more faces than this is not drawn as it is.
  std::size_t max_whole_faces = 250'000;
  /// The largest number of faces round the defects of such a mesh that are drawn as they are.
  std::size_t max_detail_faces = 100'000;
  /// The approximate number of faces to which the rest of such a mesh is decimated.
  std::size_t max_context_faces = 100'000;
  /// The largest number of defects of each code that are listed and highlighted.
  std::size_t max_defects_of_a_code = 500;
  /// The largest number of faces, of segments and of points that are highlighted for one defect.
  std::size_t max_elements_of_a_defect = 2'000;
  /// The largest number of elements of all defects together that are highlighted. Defects that have
  /// more than their share are cut, all to the same size.
  std::size_t max_elements_of_all = 100'000;
  /// The largest number of segments that are drawn of each of SceneLines.
  std::size_t max_segments = 200'000;
};

/// Decides what is drawn of a mesh.
///
/// Degenerate and zero-area faces are drawn too, as lines. A small mesh is drawn in detail. A
/// larger one is drawn in detail round its defects (breadth first, with the same number of rings
/// round all, up to the limit), and decimated elsewhere by vertex clustering (Rossignac and Borrel
/// 1993, "Multi-resolution 3D approximations for rendering complex scenes").
///
/// @param source  The mesh and its defects.
/// @param names   The fields to draw.
/// @throws InvalidArgument  if a position of the mesh is not finite.
/// @complexity    O(#V + #F) and the size of the defects.
[[nodiscard]] Scene make_scene(const FieldSource& source, const std::vector<FieldName>& names,
                               const SceneLimits& limits = {});

/// Adds a field of the mesh that a scene was made of.
void add_field(Scene& scene, const Field& field);

/// A place of a mesh that a repair has changed: faces of the soup, and edges by their vertices.
struct ChangedPlace {
  std::vector<Index> faces;
  std::vector<std::array<Index, 2>> edges;
};

/// Highlights the places that were changed, as far as their faces are drawn in detail.
///
/// @param scene  The scene of the soup, whose Scene::changes is set.
/// @complexity   O(#V + #F) and the size of the changes.
void highlight_changes(Scene& scene, const Soup& soup, std::span<const ChangedPlace> changes,
                       const SceneLimits& limits = {});

}  // namespace meshalyzer
