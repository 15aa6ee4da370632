#include "meshalyzer/report/text/mesh_report.h"

#include "meshalyzer/analysis/goodness.h"
#include "meshalyzer/report/text/components.h"
#include "meshalyzer/report/text/curvature.h"
#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/offenders.h"
#include "meshalyzer/report/text/sections.h"
#include "meshalyzer/report/text/statistics.h"

#include <utility>

namespace meshalyzer {
namespace {

void append_sections(TextLines& lines, const Analysis& analysis) {
  if (const std::optional<Goodness>& verdict = verdict_of(analysis)) {
    lines.line("verdict", verdict_text(*verdict));
  }
  if (!analysis.has_characteristics) {
    lines.heading("MESH ATTRIBUTES");
    lines.line("file", analysis.path);
    append_attributes(lines, analysis.attributes);
    return;
  }
  lines.heading("MESH FILE INTEGRITY");
  append_integrity(lines, analysis);
  lines.heading("MESH ATTRIBUTES");
  append_attributes(lines, analysis.attributes);
  lines.heading("MESH CHARACTERISTICS");
  append_counts(lines, analysis.characteristics);
  append_extent(lines, analysis.characteristics);
  append_measures(lines, analysis.characteristics);
  if (analysis.curvature) {
    append_curvature(lines, *analysis.curvature);
  }
  append_components(lines, analysis);
}

/// Appends the verdict: one character for a program; with the offenders, a sentence and its reasons
/// for a person.
void append_verdict(TextLines& lines, const Goodness& goodness, OffenderStyle style) {
  if (style == OffenderStyle::None) {
    lines.text() += goodness.good ? "1\n" : "0\n";
    return;
  }
  lines.text() += goodness.good ? "mesh is good\n" : "mesh is NOT good\n";
  for (const std::string& reason : goodness.reasons) {
    lines.line("reason", reason);
  }
}

}  // namespace

std::string text_report(const Analysis& analysis, OffenderStyle offenders) {
  TextLines lines;
  if (analysis.goodness) {
    append_verdict(lines, *analysis.goodness, offenders);
  } else {
    append_sections(lines, analysis);
  }
  append_offenders(lines, analysis, offenders);
  return std::move(lines.text());
}

}  // namespace meshalyzer
