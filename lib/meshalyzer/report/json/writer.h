#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The layout of the members of a JSON object or array.
enum class JsonLayout {
  /// One member per line, indented: for people, and for comparison by diff.
  Lines,
  /// All members on one line, including nested ones: for short rows, lists of numbers, and a whole
  /// text that must be one line.
  Row,
};

/// Writes JSON text from its beginning to its end.
///
/// It streams, because a tree of values costs gigabytes if a mesh has millions of offenders. It is
/// our own, because each real must be the shortest text that reads back the same (Grisu2, which the
/// usual library uses, is sometimes longer). Finite numbers are written exactly, others as null.
///
/// The caller balances begin_ and end_, and writes a key before each value of an object.
class JsonWriter {
 public:
  void begin_object(JsonLayout layout = JsonLayout::Lines) { begin('{', layout); }
  void end_object() { end('}'); }
  void begin_array(JsonLayout layout = JsonLayout::Lines) { begin('[', layout); }
  void end_array() { end(']'); }

  void key(std::string_view name);

  void null();
  void value(double real);
  /// Writes a text; bytes that are not UTF-8 become U+FFFD, so that a path in any encoding leaves
  /// the report readable.
  void value(std::string_view text);
  /// Writes a truth value; it is a template, so that no pointer converts to bool.
  template <std::same_as<bool> Bool>
  void value(Bool truth) {
    literal(truth ? "true" : "false");
  }
  template <std::integral Integer>
  requires(!std::same_as<Integer, bool>) void value(Integer integer) {
    literal(std::to_string(integer));
  }
  template <typename T>
  void value(const std::optional<T>& maybe) {
    maybe ? value(*maybe) : null();
  }

  /// Writes an array of the values of a range.
  template <typename Range>
  void array(const Range& values, JsonLayout layout = JsonLayout::Row) {
    begin_array(layout);
    for (const auto& element : values) value(element);
    end_array();
  }

  /// Writes text that is already JSON: a value, or members of an object.
  void verbatim(std::string_view json) { literal(json); }

  /// Writes a key and its value.
  template <typename T>
  void member(std::string_view name, const T& content) {
    key(name);
    value(content);
  }

  /// Returns the length of the text that can be drained.
  [[nodiscard]] std::size_t pending() const { return text_.size(); }

  /// Returns the text since the beginning or the last drain(), at any point; writing can continue.
  /// So a text of any length needs little memory.
  [[nodiscard]] std::string drain();

  /// Returns the rest of the text, ended by a line feed; leaves the writer empty, ready for another
  /// text.
  [[nodiscard]] std::string take();

 private:
  struct Level {
    JsonLayout layout = JsonLayout::Lines;
    bool empty = true;
  };

  void begin(char bracket, JsonLayout layout);
  void end(char bracket);
  void literal(std::string_view text);
  void quoted(std::string_view text);
  /// Writes the separator of two members: comma, line feed and indentation, or blank.
  void separate();
  void new_line();

  std::string text_;
  std::vector<Level> levels_;
  bool after_key_ = false;
};

}  // namespace meshalyzer
