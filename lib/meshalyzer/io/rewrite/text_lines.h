#pragma once

#include "meshalyzer/io/rewrite/byte_edits.h"
#include "meshalyzer/io/text_scanner.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// Returns the words of the record that begins at an offset of a text.
[[nodiscard]] std::vector<std::string_view> words_at(std::string_view text, std::size_t begin,
                                                     Continuation continuation);

/// Returns the offset of a line of a text, counted from 1.
[[nodiscard]] std::size_t line_offset(std::string_view text, std::size_t line);

/// Edits of a text whose records are lines.
class LineEdits : public ByteEdits {
 public:
  explicit LineEdits(std::string_view text);

  /// Returns "\n" or "\r\n", whichever ends the first line of the text.
  [[nodiscard]] const std::string& line_end() const { return line_end_; }

  /// Replaces the lines of a record. A comment after the record then follows the first new line, or
  /// is lost if there is none.
  /// @param record  The record, from its first word to its last; a view into the text.
  /// @param lines   The new lines, each with its line end; none to drop the record.
  void replace_lines(std::string_view record, std::string lines);
  /// Inserts lines after the last line of a record.
  void insert_lines_behind(std::string_view record, std::string lines);
  /// Replaces those of some numbers whose values have changed.
  /// @param words  The numbers in the text; there may be more words after them.
  void replace_numbers(std::span<const std::string_view> words, std::span<const double> before,
                       std::span<const double> now);
  /// Replaces an integer, unless it already has that value in any notation.
  void replace_integer(std::string_view part, std::int64_t number);
  /// Records that the comments in a part of the text are lost.
  void note_lost_comments(std::string_view part);
  /// Drops a part of the text, and its lines if they hold nothing else. Comments in it are lost.
  void erase_with_lines(std::string_view part);

 private:
  /// Returns the begin of the line that contains this offset.
  [[nodiscard]] std::size_t line_begin(std::size_t offset) const;
  [[nodiscard]] std::size_t next_line(std::size_t offset) const;
  /// Tells whether the line that ends before an offset, where the next one begins, ends in a
  /// backslash.
  [[nodiscard]] bool is_continued(std::size_t next) const;

  std::string line_end_;
};

/// Returns the record of these words, as a view.
[[nodiscard]] std::string_view span_of(const std::vector<std::string_view>& words);

}  // namespace meshalyzer
