#include "meshalyzer/report/html/attribute_tables.h"

#include "meshalyzer/report/html/definitions.h"

#include <string>
#include <vector>

namespace meshalyzer {
namespace {

void append_titles(HtmlWriter& html, const TextTable& table) {
  const HtmlElement head(html, "thead");
  const HtmlElement row(html, "tr");
  const std::vector<std::string>& titles = table.rows.front();
  for (std::size_t column = 0; column < titles.size(); ++column) {
    const bool is_number = column >= table.n_name_columns;
    html.element("th", {{"scope", "col"}, {"class", is_number ? "number" : "name"}},
                 titles[column]);
  }
}

/// Appends the entries of a row; the first one names it.
void append_entries(HtmlWriter& html, const std::vector<std::string>& entries,
                    std::size_t n_name_columns) {
  const HtmlElement row(html, "tr");
  for (std::size_t column = 0; column < entries.size(); ++column) {
    const std::string_view kind = column >= n_name_columns ? "number" : "name";
    if (column == 0) {
      html.element("th", {{"scope", "row"}, {"class", kind}}, entries[column]);
    } else {
      html.element("td", {{"class", kind}}, entries[column]);
    }
  }
}

}  // namespace

void append_term(HtmlWriter& html, std::string_view term) {
  const std::string_view definition = definition_of(term);
  if (definition.empty()) {
    html.text(term);
    return;
  }
  std::string id = "def-";
  id += slug(term);
  html.element("span", {{"class", "term"}, {"tabindex", "0"}, {"aria-describedby", id}}, term);
  html.element("span", {{"class", "definition"}, {"role", "tooltip"}, {"id", id}}, definition);
}

void append_rows(HtmlWriter& html, const ReportRows& rows) {
  const HtmlElement table(html, "table");
  const HtmlElement body(html, "tbody");
  for (const ReportRow& row : rows.rows()) {
    const HtmlElement line(html, "tr");
    {
      const HtmlElement name(html, "th", {{"scope", "row"}});
      append_term(html, row.name);
    }
    html.element("td", row.value);
  }
}

void append_text_table(HtmlWriter& html, const TextTable& table, TableOrder order) {
  const HtmlElement wide(html, "div", {{"class", "wide"}});
  const HtmlElement element(html, "table",
                            {{"class", order == TableOrder::ByColumn ? "sortable" : "plain"}});
  append_titles(html, table);
  const HtmlElement body(html, "tbody");
  for (std::size_t row = 1; row < table.rows.size(); ++row) {
    append_entries(html, table.rows[row], table.n_name_columns);
  }
}

}  // namespace meshalyzer
