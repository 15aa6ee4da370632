#include "meshalyzer/report/html/writer.h"

#include "meshalyzer/base/control_characters.h"
#include "meshalyzer/report/utf8.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace meshalyzer {
namespace {

/// The elements that begin a line of the source, for readability; a line feed before their tags has
/// no meaning.
constexpr std::array<std::string_view, 27> kOnOwnLine{
    "body",   "details", "div",   "figcaption", "figure", "footer", "h1",    "h2", "h3",
    "head",   "header",  "li",    "main",       "meta",   "nav",    "ol",    "p",  "rect",
    "script", "section", "style", "summary",    "svg",    "table",  "title", "tr", "ul"};

bool is_on_own_line(std::string_view tag) {
  return std::find(kOnOwnLine.begin(), kOnOwnLine.end(), tag) != kOnOwnLine.end();
}

void append_ascii(std::string& html, char c) {
  switch (c) {
    case '&':
      html += "&amp;";
      return;
    case '<':
      html += "&lt;";
      return;
    case '>':
      html += "&gt;";
      return;
    case '"':
      html += "&quot;";
      return;
    default:
      html += c;
  }
}

/// Tells whether a character is U+FFFE or U+FFFF, which no XML document may contain.
bool is_no_xml_character(std::string_view character) {
  return character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF";
}

bool is_lower_or_digit(char c) {
  return ('a' <= c && c <= 'z') || ('0' <= c && c <= '9');
}

char lower(char c) {
  return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool is_plain_in_address(char c) {
  return is_lower_or_digit(lower(c)) || std::string_view("-._~/").find(c) != std::string_view::npos;
}

}  // namespace

void append_escaped_html(std::string& html, std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_sequence_length(text, i);
    const bool is_space = text[i] == '\n' || text[i] == '\t';
    if (length == 0 || is_no_xml_character(text.substr(i, length)) ||
        (control_length(text, i) > 0 && !is_space)) {
      html += kReplacementCharacter;
    } else if (length == 1) {
      append_ascii(html, text[i]);
    } else {
      html += text.substr(i, length);
    }
    i += std::max<std::size_t>(1, length);
  }
}

std::string address_of(std::string_view path) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string address;
  for (const char c : path) {
    if (is_plain_in_address(c)) {
      address += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    address += '%';
    address += kHex[byte / 16U];
    address += kHex[byte % 16U];
  }
  return address;
}

std::string slug(std::string_view text) {
  std::string word;
  for (const char letter : text) {
    const char c = lower(letter);
    if (is_lower_or_digit(c)) {
      word += c;
    } else if (!word.empty() && word.back() != '-') {
      word += '-';
    }
  }
  if (!word.empty() && word.back() == '-') word.pop_back();
  return word;
}

void HtmlWriter::element(std::string_view tag, HtmlAttributes attributes, std::string_view text) {
  const HtmlElement element(*this, tag, attributes);
  this->text(text);
}

void HtmlWriter::start(std::string_view tag, HtmlAttributes attributes) {
  if (is_on_own_line(tag)) html_ += '\n';
  html_ += '<';
  html_ += tag;
  for (const HtmlAttribute& attribute : attributes) {
    html_ += ' ';
    html_ += attribute.name;
    html_ += "=\"";
    append_escaped_html(html_, attribute.value);
    html_ += '"';
  }
  html_ += '>';
}

void HtmlWriter::end(std::string_view tag) {
  html_ += "</";
  html_ += tag;
  html_ += '>';
}

}  // namespace meshalyzer
