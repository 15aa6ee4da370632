#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace meshalyzer {

/// A real for people: ten significant digits at most, no locale, no "-0".
[[nodiscard]] std::string readable(double value);

/// What stands in the place of a value that there is none of, with the reason where there is one.
[[nodiscard]] std::string undefined(const std::string& reason);

/// Collects the lines of a text report.
class TextLines {
 public:
  /// Begins a section; a blank line stands before each but the first.
  void heading(std::string_view title);

  /// One `name: value` line.
  void line(std::string_view name, std::string_view value);
  void line(std::string_view name, const char* value) { line(name, std::string_view(value)); }
  void line(std::string_view name, double value) { line(name, readable(value)); }
  /// A template, so that no pointer converts to bool.
  template <std::same_as<bool> Bool>
  void line(std::string_view name, Bool value) {
    line(name, value ? "yes" : "no");
  }
  template <std::integral Integer>
  requires(!std::same_as<Integer, bool>) void line(std::string_view name, Integer value) {
    line(name, std::string_view(std::to_string(value)));
  }

  /// The text so far, for what is written in another form; keep it ending in a line feed.
  [[nodiscard]] std::string& text() { return text_; }

 private:
  std::string text_;
};

}  // namespace meshalyzer
