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
};

inline constexpr std::size_t kFieldNames = 10;

/// All of them, in the order of the enumeration, which is that of menus.
[[nodiscard]] const std::vector<FieldName>& all_field_names();
/// "gaussian", "mean", "k1", "k2", "valence", "aspect-ratio", "area", "component", "defect",
/// "separation".
[[nodiscard]] std::string_view field_name(FieldName name);
/// The field of a name; nothing where there is none of that name.
[[nodiscard]] std::optional<FieldName> field_of(std::string_view name);
/// For a person, with its symbol and unit: "Gaussian curvature K (1/length²)".
[[nodiscard]] std::string_view field_label(FieldName name);

/// What a field has values of.
enum class FieldPlace : std::uint8_t { Vertices, Faces };

/// How a field's values are to be shown.
enum class FieldKind : std::uint8_t {
  /// Sizes, none negative: along a sequential palette.
  Magnitude,
  /// Values of both signs: along a diverging palette, its middle at 0.
  Signed,
  /// Numbers that name something (a component, a defect's code): a colour each, without an order.
  Category,
};

/// A value for each element of a mesh.
struct Field {
  FieldName name = FieldName::Gaussian;
  FieldPlace place = FieldPlace::Vertices;
  FieldKind kind = FieldKind::Magnitude;
  /// #V or #F of the soup, by record; NaN where there is none, infinite for the aspect ratio of a
  /// face of zero area.
  std::vector<double> values;
};

/// What fields are computed of. Only referred to.
struct FieldSource {
  const PreparedMesh& mesh;
  /// For the field `defect`; may be null.
  const DefectReport* defects = nullptr;
  /// For the field `separation`; may be null.
  const ObjectSeparation* separation = nullptr;
  VertexArea area = VertexArea::Mixed;
};

/// Computes fields; several at once share what they have in common.
///
/// Of vertices: the curvatures (NaN where the surface has none), the valence (edges at the vertex)
/// and the separation (signed where a distance is negative); no value where no face of the complex
/// uses the vertex. Of faces: aspect ratio, area, component (from 0, in order of their lowest face)
/// and defect: 0 where the face, its vertices, edges and component are in no listed defect, else 1
/// + the place of the worst one's code in DefectCode (errors before warnings, then the first code).
/// Faces that are not in the complex have no value but for `defect`.
///
/// @param names  Fields for which the source has not what they need are left out.
/// @return       In the order of `names`.
/// @complexity   O(#V + #F).
[[nodiscard]] std::vector<Field> compute_fields(const FieldSource& source,
                                                const std::vector<FieldName>& names);

/// The values of a field at the vertices, for formats that know no others: of a face field the
/// largest value of the faces round the vertex (for `area` a third of their sum, so that the total
/// stays; for `defect` the worst).
/// @param soup  What the field is of.
/// @return      #V; NaN where there is none.
/// @complexity  O(#V + #F).
[[nodiscard]] std::vector<double> at_vertices(const Field& field, const Soup& soup);

/// The range of colours that shows a field best: for a signed field symmetric about 0. Outliers do
/// not take all colours: the ends are the 2nd and the 98th percentile of the finite values (nearest
/// rank), where these differ by more than rounding does, a billionth of the range of all; else the
/// smallest and the largest. Categories run from the smallest to the largest.
/// @complexity O(#values).
[[nodiscard]] ColourScale scale_of(const Field& field);

/// Light grey: that of faces in no defect.
inline constexpr Colour kNoDefectColour{217, 217, 217};

/// What colours the values of a field have.
struct FieldColours {
  FieldName name = FieldName::Gaussian;
  /// Absent for categories, which have a category_colour() each: component 0 and the first code of
  /// defects the first one.
  std::optional<ColourScale> scale = std::nullopt;

  [[nodiscard]] Colour of(double value) const;
};

/// The colours of a field: along scale_of(); of categories a colour each.
/// @param palette  In place of the field's own; then categories run along it too.
[[nodiscard]] FieldColours colours_of(const Field& field,
                                      std::optional<Palette> palette = std::nullopt);

}  // namespace meshalyzer
