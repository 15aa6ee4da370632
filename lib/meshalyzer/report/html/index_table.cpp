#include "meshalyzer/report/html/index_table.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/report/html/attribute_tables.h"
#include "meshalyzer/report/text/lines.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace meshalyzer {
namespace {

std::string_view state_text(RowState state) {
  switch (state) {
    case RowState::Good:
      return "good";
    case RowState::NotGood:
      return "not good";
    case RowState::Unreadable:
      return "unreadable";
    case RowState::NotJudged:
      break;
  }
  return "-";
}

std::string_view state_class(RowState state) {
  switch (state) {
    case RowState::Good:
      return "name state good";
    case RowState::NotGood:
      return "name state not-good";
    case RowState::Unreadable:
      return "name state unreadable";
    case RowState::NotJudged:
      break;
  }
  return "name";
}

/// A mesh of the set, and notes on its relation to the others.
struct NotedRow {
  const IndexRow& row;
  std::span<const std::string> notes;
};

/// Returns the reasons for the verdict in words, and the notes.
std::string why(const NotedRow& noted) {
  if (!noted.row.error.empty()) return noted.row.error;
  std::string text;
  for (const std::span<const std::string> sentences :
       {std::span<const std::string>(noted.row.reasons), noted.notes}) {
    for (const std::string& sentence : sentences) {
      if (!text.empty()) text += "; ";
      text += sentence;
    }
  }
  return text;
}

/// The columns that depend on the content of the rows.
struct Columns {
  std::vector<DefectCode> codes;
  bool has_separation = false;
};

Columns columns_of(const std::vector<IndexRow>& rows) {
  Columns columns;
  for (const DefectCode code : all_defect_codes()) {
    const auto has_code = [&](const IndexRow& row) {
      return row.defects[static_cast<std::size_t>(code)] != 0;
    };
    if (std::any_of(rows.begin(), rows.end(), has_code)) columns.codes.push_back(code);
  }
  columns.has_separation =
      std::any_of(rows.begin(), rows.end(), [](const IndexRow& row) { return row.separation; });
  return columns;
}

void append_title(HtmlWriter& html, std::string_view kind, std::string_view title) {
  html.element("th", {{"scope", "col"}, {"class", kind}}, title);
}

void append_titles(HtmlWriter& html, const Columns& columns) {
  const HtmlElement head(html, "thead");
  const HtmlElement row(html, "tr");
  append_title(html, "name", "mesh");
  append_title(html, "name", "verdict");
  append_title(html, "name", "why");
  for (const std::string_view title : {"defects", "faces", "vertices", "area", "volume"}) {
    append_title(html, "number", title);
  }
  if (columns.has_separation) append_title(html, "number", "smallest separation");
  for (const DefectCode code : columns.codes) append_title(html, "number", defect_name(code));
}

void append_number(HtmlWriter& html, const std::string& text) {
  html.element("td", {{"class", "number"}}, text);
}

void append_measure(HtmlWriter& html, const std::optional<double>& value) {
  append_number(html, value ? readable(*value) : "-");
}

void append_name(HtmlWriter& html, const IndexRow& row) {
  const HtmlElement name(html, "th", {{"scope", "row"}, {"class", "name"}});
  if (row.page.empty() || state_of(row) == RowState::Unreadable) {
    html.text(row.name);
  } else {
    html.element("a", {{"href", address_of(row.page)}}, row.name);
  }
}

void append_count(HtmlWriter& html, const IndexRow& row, std::size_t count) {
  append_number(html, state_of(row) == RowState::Unreadable ? "-" : grouped(count));
}

/// Appends a count; counts that are not zero stand out.
/// @param worst  The worst severity of the counted defects.
void append_found(HtmlWriter& html, const IndexRow& row, std::size_t count, Severity worst) {
  if (count == 0) {
    append_count(html, row, count);
  } else {
    const std::string_view kind = worst == Severity::Error ? "number found" : "number warned";
    html.element("td", {{"class", kind}}, grouped(count));
  }
}

void append_all_defects(HtmlWriter& html, const IndexRow& row) {
  std::size_t count = 0;
  Severity worst = Severity::Warning;
  for (const DefectCode code : all_defect_codes()) {
    const std::size_t n = row.defects[static_cast<std::size_t>(code)];
    count += n;
    if (n != 0 && catalogue_entry(code).severity == Severity::Error) worst = Severity::Error;
  }
  append_found(html, row, count, worst);
}

/// Appends the verdict. A mesh that is good by itself but intersects others must not appear as
/// good.
void append_verdict(HtmlWriter& html, const NotedRow& noted) {
  const RowState state = state_of(noted.row);
  if (state == RowState::Good && !noted.notes.empty()) {
    html.element("td", {{"class", state_class(RowState::NotGood)}}, "good only by itself");
  } else {
    html.element("td", {{"class", state_class(state)}}, state_text(state));
  }
}

void append_row(HtmlWriter& html, const NotedRow& noted, const Columns& columns) {
  const IndexRow& row = noted.row;
  const HtmlElement line(html, "tr");
  append_name(html, row);
  append_verdict(html, noted);
  html.element("td", {{"class", "name why"}}, why(noted));
  append_all_defects(html, row);
  append_count(html, row, row.faces);
  append_count(html, row, row.vertices);
  append_measure(html, row.area);
  append_measure(html, row.volume);
  if (columns.has_separation) append_measure(html, row.separation);
  for (const DefectCode code : columns.codes) {
    append_found(html, row, row.defects[static_cast<std::size_t>(code)],
                 catalogue_entry(code).severity);
  }
}

}  // namespace

RowState state_of(const IndexRow& row) {
  if (!row.error.empty()) return RowState::Unreadable;
  if (row.good) return RowState::Good;
  return row.reasons.empty() ? RowState::NotJudged : RowState::NotGood;
}

void append_meshes_section(HtmlWriter& html, const std::vector<IndexRow>& rows,
                           const std::vector<std::vector<std::string>>& notes) {
  const HtmlSection section(html, "meshes", "Meshes");
  const Columns columns = columns_of(rows);
  const HtmlElement wide(html, "div", {{"class", "wide"}});
  const HtmlElement table(html, "table", {{"class", "sortable"}});
  append_titles(html, columns);
  const HtmlElement body(html, "tbody");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto notes_of_row =
        i < notes.size() ? std::span(notes[i]) : std::span<const std::string>();
    append_row(html, {rows[i], notes_of_row}, columns);
  }
}

}  // namespace meshalyzer
