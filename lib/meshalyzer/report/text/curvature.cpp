#include "meshalyzer/report/text/curvature.h"

#include "meshalyzer/report/text/statistics.h"

namespace meshalyzer {
namespace {

/// Appends the number of vertices without curvature for a reason; nothing if there are none.
void append_without(LineSink& lines, const CurvatureStatistics& curvature, CurvatureState state,
                    std::string_view name) {
  const std::size_t count = curvature.vertices[static_cast<std::size_t>(state)];
  if (count != 0) {
    lines.line(name, count);
  }
}

}  // namespace

void append_curvature_counts(LineSink& lines, const CurvatureStatistics& curvature) {
  lines.line("curvature area", area_name(curvature.area));
  append_without(lines, curvature, CurvatureState::Border,
                 "vertices without curvature, on a border");
  append_without(lines, curvature, CurvatureState::NotOneFan,
                 "vertices without curvature, not one fan");
  append_without(lines, curvature, CurvatureState::NoArea, "vertices without curvature, no area");
  lines.line("total angle defect", curvature.total_angle_defect);
}

void append_curvature(TextLines& lines, const CurvatureStatistics& curvature) {
  append_curvature_counts(lines, curvature);
  for (const auto& [quantity, member] : kCurvatures) {
    append_statistics(lines, quantity, curvature.*member);
  }
}

}  // namespace meshalyzer
