#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// Appends a text to an HTML or XML document, also within an attribute in double quotes: markup is
/// escaped; invalid UTF-8, control characters, U+FFFE and U+FFFF, which a document may not contain,
/// become U+FFFD, and so do controls of the direction of writing, which would turn round the text
/// that follows.
void append_escaped_html(std::string& html, std::string_view text);

/// Returns the relative address of a file for `href`: reserved and forbidden bytes are
/// percent-encoded, except '/'.
/// @param path  The relative path, with '/' between folders.
[[nodiscard]] std::string address_of(std::string_view path);

/// Returns a part of an id: the letters and digits of a text in lower case, with '-' for each run
/// of other characters.
[[nodiscard]] std::string slug(std::string_view text);

/// An attribute of an element; the value is escaped when written.
struct HtmlAttribute {
  std::string_view name;
  std::string_view value;
};
using HtmlAttributes = std::initializer_list<HtmlAttribute>;

/// Writes an HTML document from its beginning to its end. Elements are closed automatically, see
/// HtmlElement.
class HtmlWriter {
 public:
  /// Writes a text, which is escaped.
  void text(std::string_view text) { append_escaped_html(html_, text); }

  /// Writes markup without escaping.
  void markup(std::string_view markup) { html_ += markup; }

  /// Writes an element that contains only text.
  void element(std::string_view tag, HtmlAttributes attributes, std::string_view text);
  void element(std::string_view tag, std::string_view text) { element(tag, {}, text); }

  /// Writes an element without end tag, such as `meta`.
  void void_element(std::string_view tag, HtmlAttributes attributes) { start(tag, attributes); }

  /// Returns the text so far, so that the caller can append to it.
  [[nodiscard]] std::string& html() { return html_; }

 private:
  friend class HtmlElement;

  void start(std::string_view tag, HtmlAttributes attributes);
  void end(std::string_view tag);

  std::string html_;
};

/// An element that is open as long as this object exists.
class HtmlElement {
 public:
  HtmlElement(HtmlWriter& html, std::string_view tag, HtmlAttributes attributes = {})
      : html_(html), tag_(tag) {
    html_.start(tag_, attributes);
  }
  HtmlElement(const HtmlElement&) = delete;
  HtmlElement& operator=(const HtmlElement&) = delete;
  ~HtmlElement() { html_.end(tag_); }

 private:
  HtmlWriter& html_;
  std::string_view tag_;
};

}  // namespace meshalyzer
