#include "meshalyzer/report/text/defects_report.h"

#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/report/format_text.h"
#include "meshalyzer/report/text/defect_lines.h"
#include "meshalyzer/report/text/patch_lines.h"

#include <string>
#include <utility>

namespace meshalyzer {
namespace {

void append_counts(TextLines& lines, const DefectReport& report, const DefectCodes& requested) {
  for (const DefectCode code : all_defect_codes()) {
    std::string count = std::to_string(report.count(code));
    if (report.count(code) != 0 && !requested.contains(code)) count += " (not asked for)";
    lines.line(defect_name(code), count);
  }
  lines.line("defects", report.total());
  lines.count("asked for", report.count(requested), report.may_have_more(requested));
}

/// Appends the passes that treat the defects found, if there are any.
void append_fixes(TextLines& lines, const DefectReport& report) {
  DefectCodes fixable;
  for (std::size_t i = 0; i < report.defects.size(); ++i) {
    if (report.defects.is_fixable(i)) fixable.insert(report.defects.code_of(i));
  }
  for (const DefectCode code : all_defect_codes()) {
    if (!fixable.contains(code)) continue;
    std::string name = "fix of ";
    name += defect_name(code);
    lines.line(name, catalogue_entry(code).passes);
  }
}

}  // namespace

std::string text_report(const FoundDefects& found, ListLength lists) {
  const MeshName& mesh = found.mesh;
  const DefectReport& report = found.defects;
  TextLines lines;
  lines.heading("DEFECTS");
  lines.line("file", mesh.path);
  lines.line("format", format_text(mesh.path, mesh.format));
  lines.line("vertices", mesh.n_vertices);
  lines.line("faces", mesh.n_faces);
  append_tolerances(lines, report);
  append_counts(lines, report, found.requested);
  if (report.total() != 0) {
    append_fixes(lines, report);
    lines.heading("WHERE");
    append_defects(lines, {mesh, report}, lists);
  }
  if (!found.patches.empty()) {
    lines.heading("WHAT A REPAIR WOULD MAKE OF SELF-INTERSECTIONS");
    append_patches(lines, {mesh, report.defects, found.patches}, lists);
  }
  return std::move(lines.text());
}

}  // namespace meshalyzer
