#include "meshalyzer/report/json/writer.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/report/utf8.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace meshalyzer {
namespace {

void append_escaped(std::string& out, char c) {
  constexpr std::string_view kHex = "0123456789abcdef";
  switch (c) {
    case '"':
      out += "\\\"";
      return;
    case '\\':
      out += "\\\\";
      return;
    case '\n':
      out += "\\n";
      return;
    case '\t':
      out += "\\t";
      return;
    default:
      break;
  }
  const auto code = static_cast<unsigned char>(c);
  if (code < 0x20) {
    out += "\\u00";
    out += kHex[code / 16U];
    out += kHex[code % 16U];
  } else {
    out += c;
  }
}

/// Returns the number of characters at the beginning of a text that stand in JSON as they are:
/// printable ones of ASCII but quotation marks and backslashes.
std::size_t n_plain(std::string_view text) {
  const auto is_plain = [](char c) { return c >= ' ' && c < 0x7F && c != '"' && c != '\\'; };
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_plain) -
                                  text.begin());
}

}  // namespace

void JsonWriter::key(std::string_view name) {
  separate();
  quoted(name);
  text_ += ": ";
  after_key_ = true;
}

void JsonWriter::null() {
  literal("null");
}

void JsonWriter::value(double real) {
  separate();
  if (std::isfinite(real)) {
    append_shortest(text_, real);
  } else {
    text_ += "null";
  }
}

void JsonWriter::value(std::string_view text) {
  separate();
  quoted(text);
}

std::string JsonWriter::drain() {
  return std::exchange(text_, {});
}

std::string JsonWriter::take() {
  text_ += '\n';
  levels_.clear();
  after_key_ = false;
  return drain();
}

void JsonWriter::begin(char bracket, JsonLayout layout) {
  separate();
  text_ += bracket;
  const bool is_in_row = !levels_.empty() && levels_.back().layout == JsonLayout::Row;
  levels_.push_back({is_in_row ? JsonLayout::Row : layout, true});
}

void JsonWriter::end(char bracket) {
  const Level level = levels_.back();
  levels_.pop_back();
  if (level.layout == JsonLayout::Lines && !level.empty) {
    new_line();
  }
  text_ += bracket;
}

void JsonWriter::literal(std::string_view text) {
  separate();
  text_ += text;
}

void JsonWriter::quoted(std::string_view text) {
  text_ += '"';
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t plain = n_plain(text.substr(i));
    text_ += text.substr(i, plain);
    i += plain;
    if (i == text.size()) break;
    const std::size_t length = utf8_sequence_length(text, i);
    if (length == 1) {
      append_escaped(text_, text[i]);
    } else {
      text_ += length == 0 ? kReplacementCharacter : text.substr(i, length);
    }
    i += length == 0 ? 1 : length;
  }
  text_ += '"';
}

void JsonWriter::separate() {
  if (std::exchange(after_key_, false) || levels_.empty()) {
    return;
  }
  Level& level = levels_.back();
  if (!level.empty) {
    text_ += ',';
  }
  if (level.layout == JsonLayout::Lines) {
    new_line();
  } else if (!level.empty) {
    text_ += ' ';
  }
  level.empty = false;
}

void JsonWriter::new_line() {
  text_ += '\n';
  text_.append(levels_.size(), ' ');
}

}  // namespace meshalyzer
