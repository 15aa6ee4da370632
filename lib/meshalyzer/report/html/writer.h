#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// Text as it stands in an HTML document, also in an attribute between double quotes: what is
/// markup is escaped; bytes that are not UTF-8 and control characters become U+FFFD, for no
/// document may have them.
void append_escaped_html(std::string& html, std::string_view text);

/// Returns the relative address of a file for `href`: bytes that mean something in an address, or
/// that it may not have, are percent-encoded; '/' stays.
/// @param path  Relative, with '/' between folders.
[[nodiscard]] std::string address_of(std::string_view path);

/// "0" ... "9", "a" ... "z" of the text, in lower case, with '-' for each run of all else: a part
/// of an id.
[[nodiscard]] std::string slug(std::string_view text);

/// An attribute of an element; the value is escaped when written.
struct HtmlAttribute {
  std::string_view name;
  std::string_view value;
};
using HtmlAttributes = std::initializer_list<HtmlAttribute>;

/// Writes an HTML document from its beginning to its end. Elements are closed by themselves, see
/// HtmlElement.
class HtmlWriter {
 public:
  /// Text that is escaped.
  void text(std::string_view text) { append_escaped_html(html_, text); }

  /// Markup of our own, as it is.
  void markup(std::string_view markup) { html_ += markup; }

  /// An element with nothing but text in it.
  void element(std::string_view tag, HtmlAttributes attributes, std::string_view text);
  void element(std::string_view tag, std::string_view text) { element(tag, {}, text); }

  /// An element that never has an end tag, such as `meta`.
  void void_element(std::string_view tag, HtmlAttributes attributes) { start(tag, attributes); }

  /// Returns what is written so far, so that the caller can append to it.
  [[nodiscard]] std::string& html() { return html_; }

 private:
  friend class HtmlElement;

  void start(std::string_view tag, HtmlAttributes attributes);
  void end(std::string_view tag);

  std::string html_;
};

/// An element that is open as long as this lives.
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
