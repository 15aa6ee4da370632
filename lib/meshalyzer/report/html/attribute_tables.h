#pragma once

#include "meshalyzer/report/html/writer.h"
#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/table.h"

#include <string_view>

namespace meshalyzer {

/// Appends a word of the report; where it has a definition, this shows when the word is pointed at
/// or has the focus. A word with a definition may stand only once on a page.
void append_term(HtmlWriter& html, std::string_view term);

/// Appends names and values, a row each.
void append_rows(HtmlWriter& html, const ReportRows& rows);

/// Tells whether a person may order the rows of a table.
enum class TableOrder { Fixed, ByColumn };

/// Appends a table with its titles: names, then numbers. Where it is wide it scrolls by itself.
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
