#include "meshalyzer/report/set_text.h"

#include "meshalyzer/report/set_verdict.h"
#include "meshalyzer/report/text_lines.h"
#include "meshalyzer/report/text_meetings.h"
#include "meshalyzer/report/text_separation.h"
#include "meshalyzer/report/text_statistics.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

namespace meshalyzer {
namespace {

void append_verdict(TextLines& lines, const SetAnalysis& set) {
  if (set.good) {
    lines.line("good meshes", fmt::format("{} of {}", *set.good, set.meshes));
  }
  for (const UnfitMesh& mesh : set.not_good) {
    lines.line("not good",
               fmt::format("{}: {}", set.names[mesh.mesh], fmt::join(mesh.reasons, "; ")));
  }
  if (const std::optional<bool> good = is_good(set)) {
    lines.line("set is good", *good);
  }
}

std::string volume_text(const Measure<double>& volume) {
  if (!volume.value) {
    return undefined(volume.reason);
  }
  const std::string note = volume.reason.empty() ? "" : " (" + volume.reason + ")";
  return readable(*volume.value) + note;
}

void append_totals(TextLines& lines, const SetAnalysis& set) {
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

}  // namespace

std::string text_report(const SetAnalysis& set, OffenderStyle offenders) {
  TextLines lines;
  lines.heading("MESH SET");
  lines.line("meshes", set.meshes);
  lines.line("unreadable files", set.unreadable);
  append_verdict(lines, set);
  append_totals(lines, set);
  if (set.statistics) {
    append_measures(lines, *set.statistics);
  }
  append_meetings(lines, set, offenders);
  append_separation(lines, set, offenders);
  return std::move(lines.text());
}

std::string between_report(const SetAnalysis& set, OffenderStyle offenders) {
  TextLines lines;
  append_meetings(lines, set, offenders);
  append_separation(lines, set, offenders);
  return std::move(lines.text());
}

}  // namespace meshalyzer
