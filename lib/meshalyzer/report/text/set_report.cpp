#include "meshalyzer/report/text/set_report.h"

#include "meshalyzer/analysis/goodness.h"
#include "meshalyzer/report/set_verdict.h"
#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/meetings.h"
#include "meshalyzer/report/text/separation.h"
#include "meshalyzer/report/text/set_totals.h"
#include "meshalyzer/report/text/statistics.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <string_view>
#include <utility>

namespace meshalyzer {
namespace {

constexpr std::string_view kSetHeading = "MESH SET";

void append_judged_meshes(TextLines& lines, const SetAnalysis& set,
                          const std::optional<Goodness>& verdict) {
  lines.line("meshes", set.meshes);
  lines.line("unreadable files", set.unreadable);
  if (set.good) {
    const bool cut_each_other = set.not_good.empty() && !verdict->good;
    lines.line("good meshes", fmt::format("{} of {}{}", *set.good, set.meshes,
                                          cut_each_other ? ", each by itself" : ""));
  }
  for (const UnfitMesh& mesh : set.not_good) {
    lines.line("not good",
               fmt::format("{}: {}", set.names[mesh.mesh], fmt::join(mesh.reasons, "; ")));
  }
}

}  // namespace

std::string text_report(const SetAnalysis& set, OffenderStyle offenders) {
  TextLines lines;
  lines.heading(kSetHeading);
  const std::optional<Goodness> verdict = set_verdict(set);
  if (verdict) lines.line("verdict", verdict_text(*verdict));
  append_judged_meshes(lines, set, verdict);
  append_set_totals(lines, set);
  if (set.statistics) {
    append_measures(lines, *set.statistics);
  }
  append_meetings(lines, set, offenders);
  append_separation(lines, set, offenders);
  return std::move(lines.text());
}

std::string text_report_between(const SetAnalysis& set, OffenderStyle offenders) {
  TextLines lines;
  const bool is_requested = set.intersections || set.separation || !set.separation_reason.empty();
  if (const std::optional<Goodness> verdict = set_verdict(set); verdict && is_requested) {
    lines.heading(kSetHeading);
    lines.line("verdict", verdict_text(*verdict));
  }
  append_meetings(lines, set, offenders);
  append_separation(lines, set, offenders);
  return std::move(lines.text());
}

}  // namespace meshalyzer
