#include "meshalyzer/report/html/defects_page.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/report/format_text.h"
#include "meshalyzer/report/html/attribute_tables.h"
#include "meshalyzer/report/html/defect_list.h"
#include "meshalyzer/report/html/page_frame.h"
#include "meshalyzer/report/text/defect_lines.h"

#include <array>
#include <cstddef>

namespace meshalyzer {
namespace {

Verdict verdict_of(const DefectReport& report, const DefectCodes& requested) {
  const std::size_t n = report.count(requested);
  if (n != 0) {
    return {Verdict::Kind::Bad, counted(n, "defect", "defects"),
            counts_of_codes([&](DefectCode code) { return report.count(code); }, requested)};
  }
  return {Verdict::Kind::Good,
          report.total() == 0 ? "Nothing is wrong" : "Nothing that was asked for is wrong"};
}

std::string facts_of(const MeshName& mesh) {
  return size_text(mesh.n_faces, mesh.n_vertices) + ", " + file_text(mesh.path, mesh.format);
}

}  // namespace

std::string html_report(const PageMesh& mesh, const DefectCodes& requested) {
  const std::array drawn{TitledMesh{"", mesh}};
  const PageHeader header{.name = file_name(mesh.name.path),
                          .verdict = verdict_of(mesh.defects, requested),
                          .facts = facts_of(mesh.name)};
  return html_page(header, drawn, [&](HtmlWriter& html) {
    append_defects_section(html, drawn);
    const HtmlSection section(html, "tolerances", "Tolerances");
    ReportRows rows;
    rows.line("file", mesh.name.path);
    append_tolerances(rows, mesh.defects);
    append_rows(html, rows);
  });
}

}  // namespace meshalyzer
