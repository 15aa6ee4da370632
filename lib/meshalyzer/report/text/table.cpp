#include "meshalyzer/report/text/table.h"

#include "meshalyzer/base/control_characters.h"
#include "meshalyzer/report/utf8.h"

#include <algorithm>

namespace meshalyzer {

std::size_t n_characters(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++count) {
    i += std::max<std::size_t>(1, utf8_sequence_length(text, i));
  }
  return count;
}

std::string truth_cell(std::optional<bool> truth) {
  return !truth ? "-" : *truth ? "yes" : "no";
}

void append_table(std::string& text, const TextTable& table) {
  std::vector<std::size_t> widths(table.rows.front().size(), 0);
  for (const std::vector<std::string>& row : table.rows) {
    std::transform(row.begin(), row.end(), widths.begin(), widths.begin(),
                   [](const std::string& entry, std::size_t width) {
                     return std::max(n_characters(entry), width);
                   });
  }
  for (const std::vector<std::string>& row : table.rows) {
    for (std::size_t column = 0; column < row.size(); ++column) {
      const std::string padding(widths[column] - n_characters(row[column]), ' ');
      const bool is_name = column < table.n_name_columns;
      text += "  ";
      const std::string cell = without_controls(row[column]);
      text += is_name ? cell + padding : padding + cell;
    }
    text += '\n';
  }
}

}  // namespace meshalyzer
