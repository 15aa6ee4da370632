#pragma once

#include "meshalyzer/report/html/writer.h"
#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/table.h"

#include <string_view>

namespace meshalyzer {

/// Appends a term of the report. Its definition, if it has one, appears when the term is pointed at
/// or has the focus. A term with a definition may occur only once on a page.
void append_term(HtmlWriter& html, std::string_view term);

/// Appends names and values, one row for each.
void append_rows(HtmlWriter& html, const ReportRows& rows);

/// The order of the rows of a table: fixed, or chosen by the reader.
enum class TableOrder { Fixed, ByColumn };

/// Appends a table with its titles: names, then numbers. A wide table scrolls by itself.
void append_text_table(HtmlWriter& html, const TextTable& table,
                       TableOrder order = TableOrder::Fixed);

/// A section of the page, with its heading: `<section id="integrity"><h2>Integrity</h2>`.
class HtmlSection {
 public:
  HtmlSection(HtmlWriter& html, std::string_view id, std::string_view title)
      : section_(html, "section", {{"id", id}}) {
    html.element("h2", title);
  }

 private:
  HtmlElement section_;
};

}  // namespace meshalyzer
