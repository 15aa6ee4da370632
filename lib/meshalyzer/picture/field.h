#pragma once

#include "meshalyzer/base/colour_map.h"
#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/geometry/curvature.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/set/separation.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// A quantity that a mesh can be coloured by.
enum class FieldName : std::uint8_t {
  Gaussian,
  Mean,
  K1,
  K2,
  Valence,
  AspectRatio,
  Area,
  Component,
  Defect,
  Separation,
  Deviation,
};

inline constexpr std::size_t kFieldNames = 11;

/// Returns the names of the fields that compute_fields() can compute, in the order of the
/// enumeration, which is also the order of menus: all but `deviation`, which compares two meshes.
[[nodiscard]] const std::vector<FieldName>& computed_field_names();
/// Returns the name of a field in commands and files: "gaussian", "mean", "k1", "k2", "valence",
/// "aspect-ratio", "area", "component", "defect", "separation", "deviation".
[[nodiscard]] std::string_view field_name(FieldName name);
/// Returns the computed field with the given name, or nothing if none has it.
[[nodiscard]] std::optional<FieldName> field_of(std::string_view name);
/// Returns the label that people read, with symbol and unit: "Gaussian curvature K (1/length²)".
[[nodiscard]] std::string_view field_label(FieldName name);

/// The elements of which a field has values.
enum class FieldPlace : std::uint8_t { Vertices, Faces };

/// Tells how a field's values are to be shown.
enum class FieldKind : std::uint8_t {
  /// Sizes, none of them negative, are shown along a sequential palette.
  Magnitude,
  /// Values of both signs are shown along a diverging palette with 0 in its middle.
  Signed,
  /// Numbers that identify something (a component, a defect code) have a colour each.
  Category,
};

/// A value for each element of a mesh.
struct Field {
  FieldName name = FieldName::Gaussian;
  FieldPlace place = FieldPlace::Vertices;
  FieldKind kind = FieldKind::Magnitude;
  /// #V or #F of the soup: the value of each record, NaN if it has none, infinite for the aspect
  /// ratio of a face of zero area.
  std::vector<double> values;
};

/// The data that fields are computed from. The caller keeps them.
struct FieldSource {
  const PreparedMesh& mesh;
  /// The defects, which the field `defect` needs; may be null.
  const DefectReport* defects = nullptr;
  /// The separation, which the field `separation` needs; may be null.
  const ObjectSeparation* separation = nullptr;
  VertexArea area = VertexArea::Mixed;
};

/// Computes fields. Computing several together shares their common work.
///
/// Vertices have the curvatures (NaN where the surface has none), the valence (the number of edges
/// at the vertex) and the separation (signed where a distance is negative), and no value if no face
/// of the complex uses the vertex. Faces have the aspect ratio, the area, the component (numbered
/// from 0, in order of their lowest face) and the defect: 0 if the face, its vertices, edges and
/// component are in no listed defect, else 1 + the position in DefectCode of the worst defect's
/// code (errors before warnings, then the first code). Faces outside the complex have a value only
/// for `defect`.
///
/// @param names  The fields. Those for which the source lacks data are skipped, and so is
///               `deviation`: see deviation_field().
/// @return       The fields in the order of `names`.
/// @throws InvalidArgument  if a position of the mesh is not finite.
/// @complexity   O(#V + #F).
[[nodiscard]] std::vector<Field> compute_fields(const FieldSource& source,
                                                const std::vector<FieldName>& names);

/// Returns the values of a field at the vertices, for formats without face values. A vertex gets
/// the largest value of its faces (for `area` a third of their sum, so that the total stays; for
/// `defect` the worst).
///
/// @param soup  The mesh that the field was computed of.
/// @return      #V: the value of each vertex; NaN where it has none.
/// @complexity  O(#V + #F).
[[nodiscard]] std::vector<double> at_vertices(const Field& field, const Soup& soup);

/// Chooses the range of colours that shows a field best; that of a signed field is symmetric about
/// 0. So that outliers do not use up the colours, the ends are the 2nd and the 98th percentile of
/// the finite values (nearest rank) if these differ by more than rounding, a billionth of the whole
/// range; else the smallest and the largest value. Categories run from the smallest to the largest.
///
/// @complexity O(#values).
[[nodiscard]] ColourScale scale_of(const Field& field);

/// The colour of faces in no defect: light grey.
inline constexpr Colour kNoDefectColour{217, 217, 217};

/// Assigns colours to the values of a field.
struct FieldColours {
  FieldName name = FieldName::Gaussian;
  /// Absent for categories, which have a category_colour() each: component 0 and the first defect
  /// code have the first one.
  std::optional<ColourScale> scale = std::nullopt;

  [[nodiscard]] Colour of(double value) const;
};

/// Chooses the colours of a field: values run along scale_of(), categories have a colour each.
///
/// @param palette  Replaces the palette of the field; categories then use it too.
[[nodiscard]] FieldColours colours_of(const Field& field,
                                      std::optional<Palette> palette = std::nullopt);

}  // namespace meshalyzer
