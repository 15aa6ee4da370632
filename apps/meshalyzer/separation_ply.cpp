#include "separation_ply.h"

#include "field_export.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/picture/separation_values.h"

#include <algorithm>
#include <vector>

namespace meshalyzer {
namespace {

/// Returns a scale that begins at 0, not at the smallest value, so that near objects look near.
ColourScale scale_from_zero(const std::vector<double>& values, std::optional<double> largest) {
  const ColourScale all = scale_for(values);
  if (all.min < 0.0) {
    const double farthest = std::max(-all.min, all.max);
    return {Palette::Diverging, -farthest, farthest};
  }
  return {Palette::Sequential, 0.0, largest.value_or(all.max)};
}

}  // namespace

void write_separation_ply(const std::string& file, const SeparationPicture& picture) {
  const Soup soup = read_mesh(picture.path);
  const Field field{FieldName::Separation, FieldPlace::Vertices, FieldKind::Magnitude,
                    separation_values(soup, picture.separation)};
  const FieldColours colours{field.name, scale_from_zero(field.values, picture.largest)};
  write_field(file, {soup, field, colours});
}

}  // namespace meshalyzer
