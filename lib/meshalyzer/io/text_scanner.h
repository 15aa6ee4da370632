#pragma once

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/types.h"
#include "meshalyzer/io/decimal.h"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace meshalyzer {

/// The largest vertex or face index that any format may name.
inline constexpr std::int64_t kLargestIndex = 0x7FFFFFFF;

/// A fault on a line of a text, thrown by code that does not know the name of the file. See
/// name_fault().
class TextFault : public std::runtime_error {
 public:
  TextFault(std::size_t line, const std::string& what) : std::runtime_error(what), line_(line) {}
  /// Returns the 1-based line.
  [[nodiscard]] std::size_t line() const noexcept { return line_; }

 private:
  std::size_t line_;
};

/// Runs a parser of text and turns its TextFault into an IoError that names the file.
template <typename Parse>
[[nodiscard]] auto name_fault(const std::string& name, Parse&& parse) {
  try {
    return parse();
  } catch (const TextFault& fault) {
    throw IoError(name, {.line = fault.line()}, fault.what());
  }
}

/// Returns content of a file for a message: in quotes, cut after 40 bytes, with unprintable bytes
/// as \xNN.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// Tells whether a backslash at the end of a line joins the next line to it.
enum class Continuation { None, Backslash };

/// Walks a text token by token and counts its lines.
///
/// Tokens are separated by blanks; `#` begins a comment that runs to the end of the line; lines end
/// with "\n" or "\r\n". The parser of a line-based format repeatedly calls next_record(), the
/// readers of one line, and end_record(); that of a token-based format calls next_record() before
/// every token. Only next_record() crosses the end of a line.
class TextScanner {
 public:
  /// @param text  The text, which must outlive the scanner.
  explicit TextScanner(std::string_view text, Continuation continuation = Continuation::None)
      : at_(text.data()), end_(text.data() + text.size()), continuation_(continuation) {}

  /// @param first_line  The number of the first line, if the text is the rest of a file.
  TextScanner(std::string_view text, std::size_t first_line) : TextScanner(text) {
    line_ = first_line;
  }

  /// Moves to the next token, over line ends and comments.
  /// @return False if the text has none.
  bool next_record() {
    for (;;) {
      skip_blanks();
      if (at_ == end_) {
        return false;
      }
      if (*at_ == '\n') {
        ++at_;
        ++line_;
      } else if (*at_ == '#') {
        skip_comment();
      } else {
        return true;
      }
    }
  }

  /// Calls next_record(), and throws "the file ends before WHAT" if there is none.
  void require_record(std::string_view what);

  /// Tells whether at most a comment is left on the line.
  [[nodiscard]] bool at_record_end() {
    skip_blanks();
    return at_ == end_ || *at_ == '\n' || *at_ == '#';
  }

  /// Throws if more than a comment is left on the line.
  void end_record() {
    if (!at_record_end()) {
      fault_surplus();
    }
  }

  /// Returns the next token of the line, or an empty one if there is none.
  [[nodiscard]] std::string_view word() {
    skip_blanks();
    const char* begin = at_;
    while (!ends_token(at_)) {
      ++at_;
    }
    return {begin, static_cast<std::size_t>(at_ - begin)};
  }

  /// Returns the next token without consuming it.
  [[nodiscard]] std::string_view peek() {
    const std::string_view token = word();
    at_ -= token.size();
    return token;
  }

  /// Returns the rest of the line without blanks at its ends; a `#` inside a word is part of the
  /// word.
  [[nodiscard]] std::string rest_of_record();

  /// Skips the rest of the line.
  void skip_record();

  /// Reads a finite number; throws on anything else.
  [[nodiscard]] double real() {
    skip_blanks();
    const Decimal<double> number = scan_real(at_, end_);
    if (number.end == nullptr || !ends_token(number.end)) {
      return unusual_real();
    }
    at_ = number.end;
    return number.value;
  }

  /// Reads three finite numbers.
  [[nodiscard]] Vec3 point() {
    const double x = real();
    const double y = real();
    const double z = real();
    return {x, y, z};
  }

  /// Reads and discards any number, even an infinite one or NaN.
  void skip_number();

  /// Reads an integer; throws on anything else.
  [[nodiscard]] std::int64_t integer() {
    skip_blanks();
    const Decimal<std::int64_t> number = scan_digits(at_, end_);
    if (number.end == nullptr || !ends_token(number.end)) {
      return unusual_integer();
    }
    at_ = number.end;
    return number.value;
  }

  /// Reads an integer from `first` to kLargestIndex; throws on anything else.
  [[nodiscard]] Index index(std::int64_t first) {
    const std::int64_t value = integer();
    if (value < first || value > kLargestIndex) {
      fault_index(value, first);
    }
    return static_cast<Index>(value);
  }

  /// Reads the number of records that follow, and rejects a count that the rest of the text cannot
  /// hold.
  /// @param bytes_each  The smallest size of a record, including its line end.
  [[nodiscard]] std::size_t count(std::size_t bytes_each, std::string_view what);

  /// Returns the 1-based line of the next token.
  [[nodiscard]] std::size_t line() const { return line_; }

  /// Returns the number of comments that next_record() has moved over.
  [[nodiscard]] std::size_t n_comments() const { return n_comments_; }

  /// Returns the number of unread bytes.
  [[nodiscard]] std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }

  [[noreturn]] void fault(const std::string& what) const { throw TextFault(line_, what); }

 private:
  static constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
  }
  [[nodiscard]] bool ends_token(const char* at) const {
    return at == end_ || is_blank(*at) || *at == '\n' || *at == '#' ||
           (*at == '\\' && is_continuation(at));
  }
  void skip_blanks() {
    while (at_ != end_ && is_blank(*at_)) {
      ++at_;
    }
    if (at_ != end_ && *at_ == '\\') {
      skip_continuation();
    }
  }
  [[nodiscard]] bool is_continuation(const char* at) const;
  void skip_continuation();
  void skip_comment();
  double unusual_real();
  std::int64_t unusual_integer();
  [[noreturn]] void fault_surplus();
  [[noreturn]] void fault_index(std::int64_t value, std::int64_t first) const;

  const char* at_;
  const char* end_;
  std::size_t line_ = 1;
  std::size_t n_comments_ = 0;
  Continuation continuation_;
};

}  // namespace meshalyzer
