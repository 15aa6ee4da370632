#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// Returns the number of characters of a UTF-8 text; an invalid byte counts as one.
[[nodiscard]] std::size_t n_characters(std::string_view text);

/// Returns the cell for a truth value: yes, no, or a dash if it is unknown.
[[nodiscard]] std::string truth_cell(std::optional<bool> truth);

/// A table for people.
struct TextTable {
  /// The number of columns, from the left, that are aligned to the left, as names are; numbers in
  /// the others are aligned to the right.
  std::size_t n_name_columns = 0;
  /// The rows, all of equal length; the first has the titles.
  std::vector<std::vector<std::string>> rows;
};

/// What follows the title of a column whose numbers are only lower bounds.
inline constexpr std::string_view kAtLeastTitle = " (at least)";

/// Appends the rows, each column as wide as its widest entry; control characters become "?".
void append_table(std::string& text, const TextTable& table);

}  // namespace meshalyzer
