#include "meshalyzer/report/text/set_totals.h"

#include <string>

namespace meshalyzer {
namespace {

std::string volume_text(const Measure<double>& volume) {
  if (!volume.value) {
    return undefined(volume.reason);
  }
  const std::string note = volume.reason.empty() ? "" : " (" + volume.reason + ")";
  return readable(*volume.value) + note;
}

}  // namespace

void append_set_totals(LineSink& lines, const SetAnalysis& set) {
  lines.line("total vertices", set.vertices);
  lines.line("total faces", set.faces);
  lines.line("total edges", set.edges);
  lines.line("total components", set.components);
  lines.line("total boundaries", set.boundaries);
  if (set.is_measured) {
    lines.line("total intersecting pairs within meshes", set.intersecting_pairs_within);
    lines.line("total area", set.area);
    lines.line("total volume", volume_text(set.volume));
  }
}

}  // namespace meshalyzer
