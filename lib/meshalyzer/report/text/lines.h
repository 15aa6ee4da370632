#pragma once

#include "meshalyzer/base/numbers.h"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {

/// Returns the text in place of an undefined value, with the reason if there is one.
[[nodiscard]] std::string undefined(std::string_view reason);

/// Returns the change of a count as "2 -> 1".
[[nodiscard]] std::string arrow(std::size_t before, std::size_t after);

/// Receives the lines of a report, each a name and a value, for any output.
class LineSink {
 public:
  LineSink() = default;
  LineSink(const LineSink&) = delete;
  LineSink& operator=(const LineSink&) = delete;
  virtual ~LineSink() = default;

  /// Adds a line `name: value`.
  void line(std::string_view name, std::string_view value) { add(name, value); }
  void line(std::string_view name, const char* value) { add(name, value); }
  void line(std::string_view name, double value) { add(name, readable(value)); }
  /// Adds a line for a truth value; it is a template, so that no pointer converts to bool.
  template <std::same_as<bool> Bool>
  void line(std::string_view name, Bool value) {
    add(name, value ? "yes" : "no");
  }
  template <std::integral Integer>
  requires(!std::same_as<Integer, bool>) void line(std::string_view name, Integer value) {
    add(name, std::in_range<std::size_t>(value) ? count_text(static_cast<std::size_t>(value))
                                                : std::to_string(value));
  }
  /// Adds a line for a count, with the words "at least" if it is only a lower bound.
  void count(std::string_view name, std::size_t count, bool is_at_least) {
    add(name, (is_at_least ? "at least " : "") + count_text(count));
  }
  /// Adds a line for the change of a count.
  virtual void change(std::string_view name, std::size_t before, std::size_t after) {
    add(name, arrow(before, after));
  }

 private:
  virtual void add(std::string_view name, std::string_view value) = 0;
  /// Returns the text of a count.
  [[nodiscard]] virtual std::string count_text(std::size_t count) const {
    return std::to_string(count);
  }
};

/// Collects the lines of a text report; control characters in names and values become "?".
class TextLines : public LineSink {
 public:
  /// Begins a section; a blank line precedes each but the first.
  void heading(std::string_view title);

  /// Returns the text so far, to which the caller may append; it must end in a line feed.
  [[nodiscard]] std::string& text() { return text_; }

 private:
  void add(std::string_view name, std::string_view value) override;

  std::string text_;
};

/// A line of a report.
struct ReportRow {
  std::string name;
  std::string value;
};

/// Collects the lines of a report as rows, for the tables of pages; counts have their digits in
/// groups.
class ReportRows : public LineSink {
 public:
  void change(std::string_view name, std::size_t before, std::size_t after) override;

  [[nodiscard]] const std::vector<ReportRow>& rows() const { return rows_; }

 private:
  void add(std::string_view name, std::string_view value) override;
  [[nodiscard]] std::string count_text(std::size_t count) const override;

  std::vector<ReportRow> rows_;
};

}  // namespace meshalyzer
