#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// Characters of a UTF-8 text; a byte that belongs to none counts as one.
[[nodiscard]] std::size_t n_characters(std::string_view text);

/// Returns the cell for a truth: yes, no, or a dash where it is not known.
[[nodiscard]] std::string truth_cell(std::optional<bool> truth);

/// A table for people.
struct TextTable {
  /// The number of columns, from the left, that are aligned to the left, as names are; numbers in
  /// the others are aligned to the right.
  std::size_t n_name_columns = 0;
  /// The first holds the titles; all are of equal length.
  std::vector<std::vector<std::string>> rows;
};

/// Appends the rows, each column as wide as its widest entry.
void append_table(std::string& text, const TextTable& table);

}  // namespace meshalyzer
