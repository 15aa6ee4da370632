#include "meshalyzer/picture/drawn_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

/// Finite numbers stay finite.
float to_float(double value) {
  constexpr double kMax = std::numeric_limits<float>::max();
  return static_cast<float>(std::isfinite(value) ? std::clamp(value, -kMax, kMax) : value);
}

std::vector<float> values_on(const Field& field, const DrawnSurface& surface) {
  const std::vector<Index>& records =
      field.place == FieldPlace::Vertices ? surface.vertices : surface.faces;
  std::vector<float> values(records.size());
  std::transform(records.begin(), records.end(), values.begin(),
                 [&](Index record) { return to_float(field.values[record]); });
  return values;
}

DrawnField draw_field(const Field& field, const DrawnSurface& detail, const DrawnSurface& context) {
  DrawnField drawn;
  drawn.name = field.name;
  drawn.place = field.place;
  drawn.kind = field.kind;
  drawn.detail = values_on(field, detail);
  drawn.context = values_on(field, context);
  drawn.scale = scale_of(field);
  std::tie(drawn.min, drawn.max) = finite_range(field.values).value_or(std::pair(0.0, 0.0));
  return drawn;
}

}  // namespace

std::vector<DrawnField> draw_fields(std::span<const Field> fields, const DrawnSurface& detail,
                                    const DrawnSurface& context) {
  std::vector<DrawnField> drawn;
  drawn.reserve(fields.size());
  for (const Field& field : fields) drawn.push_back(draw_field(field, detail, context));
  return drawn;
}

}  // namespace meshalyzer
