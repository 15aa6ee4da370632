#include "meshalyzer/report/json_writer.h"

#include "meshalyzer/base/numbers.h"

#include <cmath>
#include <utility>

namespace meshalyzer {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

unsigned byte_at(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
}

/// The range that the second byte of a sequence must lie in: it rules out overlong forms,
/// surrogates and what is beyond U+10FFFF (Unicode standard, table 3-7).
bool is_second_byte(unsigned lead, unsigned second) {
  const unsigned low = lead == 0xE0U ? 0xA0U : lead == 0xF0U ? 0x90U : 0x80U;
  const unsigned high = lead == 0xEDU ? 0x9FU : lead == 0xF4U ? 0x8FU : 0xBFU;
  return low <= second && second <= high;
}

/// Length of the UTF-8 sequence that begins at `i`; 0 where none does.
std::size_t sequence_length(std::string_view text, std::size_t i) {
  const unsigned lead = byte_at(text, i);
  if (lead < 0x80U) {
    return 1;
  }
  const std::size_t length = lead < 0xC2U   ? 0
                             : lead < 0xE0U ? 2
                             : lead < 0xF0U ? 3
                             : lead < 0xF5U ? 4
                                            : 0;
  if (length == 0 || !is_second_byte(lead, byte_at(text, i + 1))) {
    return 0;
  }
  for (std::size_t k = 2; k < length; ++k) {
    if ((byte_at(text, i + k) & 0xC0U) != 0x80U) {
      return 0;
    }
  }
  return length;
}

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

std::string JsonWriter::take() {
  text_ += '\n';
  levels_.clear();
  after_key_ = false;
  return std::exchange(text_, {});
}

void JsonWriter::begin(char bracket, JsonLayout layout) {
  separate();
  text_ += bracket;
  levels_.push_back({layout, true});
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
    const std::size_t length = sequence_length(text, i);
    if (length == 1) {
      append_escaped(text_, text[i]);
    } else {
      text_ += length == 0 ? kReplacement : text.substr(i, length);
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
