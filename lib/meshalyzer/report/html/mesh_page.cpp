#include "meshalyzer/report/html/mesh_page.h"

#include "meshalyzer/analysis/fields.h"
#include "meshalyzer/analysis/goodness.h"
#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/report/format_text.h"
#include "meshalyzer/report/html/attribute_tables.h"
#include "meshalyzer/report/html/defect_list.h"
#include "meshalyzer/report/html/page_frame.h"
#include "meshalyzer/report/html/statistics_section.h"
#include "meshalyzer/report/text/components.h"
#include "meshalyzer/report/text/sections.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string_view>

namespace meshalyzer {
namespace {

constexpr std::size_t kShownComponents = 100;

/// Returns the attributes as a verdict, "Closed, not manifold", for a mesh whose goodness was not
/// judged.
Verdict attributes_as_verdict(const Attributes& attributes) {
  std::string text;
  for_each_row(kAttributeFields, [&](const auto& row) {
    const std::optional<bool>& value = (attributes.*row.member).value;
    if (!text.empty()) text += ", ";
    if (value == false) text += "not ";
    text += row.info.label;
    if (!value) text += " undefined";
  });
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return {Verdict::Kind::None, text};
}

Verdict page_verdict(const Analysis& analysis) {
  const std::optional<Goodness>& goodness = verdict_of(analysis);
  if (!goodness) return attributes_as_verdict(analysis.attributes);
  return goodness->good ? Verdict{Verdict::Kind::Good, "Good"}
                        : Verdict{Verdict::Kind::Bad, "Not good", goodness->reasons};
}

std::string facts_of(const Analysis& analysis) {
  const Characteristics& c = analysis.characteristics;
  const std::string components =
      c.components > 1 ? ", " + counted(c.components, "component", "components") : "";
  return size_text(c.faces, c.vertices) + components + ", " +
         file_text(analysis.path, analysis.format);
}

template <typename Append>
void append_section(HtmlWriter& html, std::string_view id, std::string_view title, Append append) {
  const HtmlSection section(html, id, title);
  ReportRows rows;
  append(rows);
  append_rows(html, rows);
}

void append_components_section(HtmlWriter& html, const Analysis& analysis) {
  const std::size_t n = analysis.components.size();
  if (n < 2) return;
  const HtmlSection section(html, "components", "Components");
  const std::size_t n_shown = std::min(n, kShownComponents);
  append_text_table(html, components_table(analysis, n_shown));
  if (n_shown == n) return;
  html.element("p", {{"class", "cut"}},
               counted(n - n_shown, "more is not shown.", "more are not shown."));
}

void append_analysis(HtmlWriter& html, const Analysis& analysis) {
  append_section(html, "attributes", "Attributes",
                 [&](LineSink& rows) { append_attributes(rows, analysis.attributes); });
  if (!analysis.has_characteristics) return;
  append_section(html, "integrity", "Integrity",
                 [&](LineSink& rows) { append_integrity(rows, analysis); });
  append_section(html, "characteristics", "Characteristics", [&](LineSink& rows) {
    append_counts(rows, analysis.characteristics);
    append_extent(rows, analysis.characteristics);
  });
  append_components_section(html, analysis);
  append_statistics_sections(html, analysis);
}

}  // namespace

std::string html_report(const MeshPage& page) {
  const std::array drawn{TitledMesh{"", page.mesh}};
  const PageHeader header{.index = page.index,
                          .name = file_name(page.mesh.name.path),
                          .verdict = page_verdict(page.analysis),
                          .facts = facts_of(page.analysis)};
  return html_page(header, drawn, [&](HtmlWriter& html) {
    append_defects_section(html, drawn);
    append_analysis(html, page.analysis);
  });
}

}  // namespace meshalyzer
