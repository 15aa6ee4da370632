#include "meshalyzer/report/text/components.h"

#include <algorithm>
#include <fmt/format.h>
#include <vector>

namespace meshalyzer {
namespace {

using Row = std::vector<std::string>;

template <typename Integer>
std::string cell_of(const std::optional<Integer>& number) {
  return number ? std::to_string(*number) : "-";
}

Row titles() {
  return {"component",  "first face", "faces",    "vertices",   "edges",
          "boundaries", "closed",     "manifold", "consistent", "outward",
          "inside",     "genus",      "area",     "volume",     "intersecting pairs"};
}

Row row_of(const Analysis& analysis, std::size_t i) {
  const ComponentAnalysis& component = analysis.components[i];
  return {std::to_string(i),
          std::to_string(analysis.face_ids.of(component.first_face)),
          std::to_string(component.faces),
          std::to_string(component.vertices),
          std::to_string(component.edges),
          std::to_string(component.boundaries),
          truth_cell(component.closed),
          truth_cell(component.manifold),
          truth_cell(component.consistent),
          truth_cell(component.outward),
          cell_of(component.inside),
          cell_of(component.genus),
          readable(component.area),
          component.volume ? readable(*component.volume) : "-",
          std::to_string(component.intersecting_pairs)};
}

}  // namespace

TextTable components_table(const Analysis& analysis, std::size_t n) {
  TextTable table{0, {titles()}};
  for (std::size_t i = 0; i < n; ++i) {
    table.rows.push_back(row_of(analysis, i));
  }
  return table;
}

void append_components(TextLines& lines, const Analysis& analysis) {
  const std::size_t n = analysis.components.size();
  if (n < 2) {
    return;
  }
  const std::size_t n_shown = std::min(n, kMaxComponentRows);
  lines.line("components, one a row",
             n_shown == n ? "all" : fmt::format("the first {} of {}", n_shown, n));
  append_table(lines.text(), components_table(analysis, n_shown));
  if (n_shown < n) {
    lines.line("components not shown",
               fmt::format("{} (the JSON report has them all)", n - n_shown));
  }
}

}  // namespace meshalyzer
