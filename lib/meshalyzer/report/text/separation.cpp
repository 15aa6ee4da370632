#include "meshalyzer/report/text/separation.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/report/text/statistics.h"

namespace meshalyzer {
namespace {

std::string_view why_without_closest(const SeparationOptions& options) {
  return options.search_radius && options.search_cone_degrees
             ? "nothing within the search radius and cone"
         : options.search_radius       ? "nothing within the search radius"
         : options.search_cone_degrees ? "nothing within the search cone"
                                       : "no other mesh";
}

std::vector<std::string> row_of(const std::string& name, const MeshSeparation& mesh) {
  const auto figure = [&](double value) {
    return mesh.distance.count == 0 ? "-" : readable(value);
  };
  return {name,
          std::to_string(mesh.distance.count + mesh.distance.infinite + mesh.without_closest),
          figure(mesh.distance.min),
          figure(mesh.distance.mean),
          figure(mesh.distance.median),
          figure(mesh.distance.max),
          std::to_string(mesh.inside),
          std::to_string(mesh.without_closest)};
}

/// Appends the separation of each mesh with its histogram.
void append_meshes_in_full(TextLines& lines, const SetAnalysis& set) {
  for (const MeshSeparation& mesh : set.separation->meshes) {
    const std::string name = set.names[mesh.mesh] + " separation distance";
    Quantity quantity = kSeparationDistance;
    quantity.info.label = name;
    append_statistics(lines, quantity, mesh.distance);
  }
}

}  // namespace

void append_separation_options(LineSink& lines, const SetSeparation& separation) {
  const SeparationOptions& options = separation.options;
  if (options.search_radius) {
    lines.line("search radius", *options.search_radius);
  }
  if (options.search_cone_degrees) {
    lines.line("search cone",
               readable(*options.search_cone_degrees) + " degrees round the vertex normal");
  }
  if (options.include_self) {
    lines.line("include self",
               "own faces farther than " + readable(*options.include_self) + " along edges");
  }
  if (separation.is_forced) {
    lines.line("forced", "yes (not every mesh is good)");
  }
}

void append_separation_counts(LineSink& lines, const SetSeparation& separation) {
  lines.line("vertices inside another mesh", separation.inside);
  std::string without = std::to_string(separation.without_closest);
  if (separation.without_closest > 0) {
    without += " (";
    without += why_without_closest(separation.options);
    without += ')';
  }
  lines.line("vertices without a closest point", without);
}

TextTable separation_table(const SetAnalysis& set) {
  TextTable table{
      1, {{"mesh", "vertices", "min", "mean", "median", "max", "inside", "without closest"}}};
  for (const MeshSeparation& mesh : set.separation->meshes) {
    table.rows.push_back(row_of(set.names[mesh.mesh], mesh));
  }
  return table;
}

void append_separation(TextLines& lines, const SetAnalysis& set, OffenderStyle style) {
  if (!set.separation && set.separation_reason.empty()) {
    return;
  }
  lines.heading("SEPARATION DISTANCES");
  if (!set.separation) {
    lines.line("separation distances", "not measured: " + set.separation_reason);
    return;
  }
  append_separation_options(lines, *set.separation);
  append_statistics(lines, kSeparationDistance, set.separation->all);
  append_separation_counts(lines, *set.separation);
  lines.line("separation distances, a mesh a row", "all");
  append_table(lines.text(), separation_table(set));
  if (style != OffenderStyle::None) {
    append_meshes_in_full(lines, set);
  }
}

}  // namespace meshalyzer
