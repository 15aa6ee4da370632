#include "meshalyzer/report/html/definitions.h"

#include "meshalyzer/analysis/fields.h"
#include "meshalyzer/set/set_analysis.h"

#include <algorithm>
#include <array>

namespace meshalyzer {
namespace {

struct Definition {
  std::string_view term;
  std::string_view meaning;
};

constexpr std::array kDefinitions{
    // The terms of the file.
    Definition{"file", "the file as it was named"},
    Definition{"format", "what the file was read as"},
    Definition{"merged points",
               "corners of an STL file that were joined: STL names no vertices, so points equal in "
               "every bit are one"},
    Definition{"polygons", "faces of more than three corners; each counts as its triangles"},
    // The terms of the extent.
    Definition{"bounding box min", "smallest x, y and z of the vertices that faces use"},
    Definition{"bounding box max", "largest x, y and z of the vertices that faces use"},
    // The terms of the curvature.
    Definition{"curvature area", "the area round a vertex that its curvature is spread over"},
    Definition{"vertices without curvature, on a border", "there the surface ends"},
    Definition{"vertices without curvature, not one fan",
               "there the faces are no surface, or do not agree which side is outside"},
    Definition{"vertices without curvature, no area",
               "there the faces have no area that a curvature could be spread over"},
    Definition{
        "total angle defect",
        "what the angles of the faces lack of a full turn, summed over the vertices: 2 pi times "
        "vertices - edges + faces"},
    // The terms of tolerances and repair.
    Definition{"degeneracy tolerance", "edges and altitudes shorter than this are defects"},
    Definition{"slit tolerance", "borders closer than this are the two sides of a slit"},
    Definition{"height tolerance", "a fold that is no higher than this is a foldover"},
    Definition{"maximum foldover angle", "in degrees: an edge whose faces are closer is a fold"},
    Definition{"maximum deviation",
               "no point of the surface may end farther than this from the other surface"},
    Definition{"largest deviation", "no point of the surface ended farther than this"},
    // The terms of sets.
    Definition{"vertices inside another mesh", "their separation distance is negative"},
    Definition{"contained meshes", "meshes that lie inside another one"},
    Definition{"partly contained meshes", "meshes some components of which lie inside another one"},
};

/// Searches a word among the labels of tables.
class Lookup {
 public:
  explicit Lookup(std::string_view term) : term_(term) {}

  void look_at(const FieldInfo& info) {
    if (info.label == term_ && !term_.empty() && definition_.empty()) {
      definition_ = info.definition;
    }
  }
  template <typename Rows>
  void look_at_fields(const Rows& rows) {
    for_each_row(rows, [&](const auto& row) { look_at(row.info); });
  }
  template <typename Rows>
  void look_at_quantities(const Rows& rows) {
    for (const auto& row : rows) look_at(row.quantity.info);
  }

  [[nodiscard]] std::string_view definition() const { return definition_; }

 private:
  std::string_view term_;
  std::string_view definition_;
};

/// Returns the definition of a term that is in no table of fields.
std::string_view other_definition(std::string_view term) {
  const auto* const found =
      std::find_if(kDefinitions.begin(), kDefinitions.end(),
                   [&](const Definition& definition) { return definition.term == term; });
  return found == kDefinitions.end() ? std::string_view() : found->meaning;
}

}  // namespace

std::string_view definition_of(std::string_view term) {
  Lookup lookup(term);
  lookup.look_at_fields(kIntegrityFields);
  lookup.look_at_fields(kAttributeFields);
  lookup.look_at_fields(kCharacteristicFields);
  lookup.look_at_quantities(kElementMeasures<Statistics>);
  lookup.look_at_quantities(kCurvatures);
  lookup.look_at(kSeparationDistance.info);
  return lookup.definition().empty() ? other_definition(term) : lookup.definition();
}

}  // namespace meshalyzer
