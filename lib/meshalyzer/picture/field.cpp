#include "meshalyzer/picture/field.h"

#include "meshalyzer/base/find_named.h"

#include <array>
#include <cstddef>

namespace meshalyzer {
namespace {

struct FieldTitle {
  FieldName name;
  std::string_view word;
  std::string_view label;
};

/// The names and labels of the fields, in the order of FieldName.
constexpr std::array<FieldTitle, kFieldNames> kTitles{{
    {FieldName::Gaussian, "gaussian", "Gaussian curvature K (1/length²)"},
    {FieldName::Mean, "mean", "Mean curvature H (1/length)"},
    {FieldName::K1, "k1", "Largest curvature k₁ (1/length)"},
    {FieldName::K2, "k2", "Smallest curvature k₂ (1/length)"},
    {FieldName::Valence, "valence", "Valence (edges at the vertex)"},
    {FieldName::AspectRatio, "aspect-ratio", "Aspect ratio (longest edge / shortest altitude)"},
    {FieldName::Area, "area", "Area A (length²)"},
    {FieldName::Component, "component", "Component"},
    {FieldName::Defect, "defect", "Defect"},
    {FieldName::Separation, "separation", "Separation d from other meshes (length)"},
    {FieldName::Deviation, "deviation",
     "Deviation d from the mesh before or after the repair (length)"},
}};

const FieldTitle& title_of(FieldName name) {
  return kTitles[static_cast<std::size_t>(name)];
}

}  // namespace

const std::vector<FieldName>& computed_field_names() {
  static const std::vector<FieldName> names = [] {
    std::vector<FieldName> computed;
    for (const FieldTitle& title : kTitles) {
      if (title.name != FieldName::Deviation) computed.push_back(title.name);
    }
    return computed;
  }();
  return names;
}

std::string_view field_name(FieldName name) {
  return title_of(name).word;
}

std::optional<FieldName> field_of(std::string_view name) {
  return find_named(computed_field_names(), name, field_name);
}

std::string_view field_label(FieldName name) {
  return title_of(name).label;
}

}  // namespace meshalyzer
